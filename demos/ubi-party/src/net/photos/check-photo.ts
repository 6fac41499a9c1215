import { MAX_PHOTO_BYTES, MAX_PHOTO_SIDE } from './photo.ts';

/**
 * Whether bytes are a JPEG file that the big screen may decode: small in bytes, and in pixels, which a file of few
 * bytes may have many of.
 */
export function isPhoto(data: Uint8Array): boolean {
  if (data.length > MAX_PHOTO_BYTES) return false;
  const size = jpegSize(data);
  return (
    size !== undefined &&
    size.width > 0 &&
    size.height > 0 &&
    Math.max(size.width, size.height) <= MAX_PHOTO_SIDE
  );
}

/** Markers of frames: SOF0 to SOF15 without DHT, JPG and DAC (ITU-T T.81, table B.1). */
const isFrame = (marker: number): boolean =>
  marker >= 0xc0 && marker <= 0xcf && ![0xc4, 0xc8, 0xcc].includes(marker);

function jpegSize(
  data: Uint8Array,
): { readonly width: number; readonly height: number } | undefined {
  const view = new DataView(data.buffer, data.byteOffset, data.byteLength);
  if (data.length < 4 || view.getUint16(0) !== 0xffd8) return undefined;
  for (let at = 2; at + 9 <= data.length;) {
    if (data[at] !== 0xff) return undefined;
    const marker = data[at + 1]!;
    if (isFrame(marker)) return { height: view.getUint16(at + 5), width: view.getUint16(at + 7) };
    at += 2 + view.getUint16(at + 2);
  }
  return undefined;
}
