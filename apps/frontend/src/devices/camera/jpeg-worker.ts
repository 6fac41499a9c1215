/** A picture to encode, with the size of the result and its quality, 0 to 1. */
export interface JpegTask {
  readonly picture: ImageBitmap;
  readonly width: number;
  readonly height: number;
  readonly quality: number;
}

/** The JPEG file; undefined if encoding failed. */
export type JpegReply = ArrayBuffer | undefined;

const canvas = new OffscreenCanvas(1, 1);
const context = canvas.getContext('2d', { willReadFrequently: true })!;

/** Scales and encodes off the main thread: there, a canvas waits for idle time, up to a second in background tabs. */
async function encode({ picture, width, height, quality }: JpegTask): Promise<ArrayBuffer> {
  if (canvas.width !== width) canvas.width = width;
  if (canvas.height !== height) canvas.height = height;
  context.drawImage(picture, 0, 0, width, height);
  picture.close();
  const blob = await canvas.convertToBlob({ type: 'image/jpeg', quality });
  return blob.arrayBuffer();
}

self.addEventListener('message', ({ data }: MessageEvent<JpegTask>) => {
  encode(data).then(
    (file) => self.postMessage(file, { transfer: [file] }),
    () => self.postMessage(undefined),
  );
});
