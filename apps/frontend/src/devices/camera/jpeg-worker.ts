/** One picture to be encoded, the size of the file and its quality, 0 to 1. */
export interface JpegTask {
  readonly picture: ImageBitmap;
  readonly width: number;
  readonly height: number;
  readonly quality: number;
}

/** The file, or nothing if the browser made none. */
export type JpegReply = ArrayBuffer | undefined;

const canvas = new OffscreenCanvas(1, 1);
const context = canvas.getContext('2d', { willReadFrequently: true })!;

/** Scales and encodes beside the page: a canvas of the page waits for idle time, a second where the page is behind another. */
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
