/** The first bytes of a JPEG file that says to have a size, filled up with zeros. */
export function jpegOf(width: number, height: number, bytes = 100): Uint8Array<ArrayBuffer> {
  const data = new Uint8Array(bytes);
  const view = new DataView(data.buffer);
  data.set([0xff, 0xd8, 0xff, 0xe0, 0, 4, 0, 0, 0xff, 0xc0, 0, 17, 8]);
  view.setUint16(13, height);
  view.setUint16(15, width);
  return data;
}
