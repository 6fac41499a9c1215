import { serveCalls, transfer } from '@ubii/worker-rpc/browser';

/** Scales and encodes off the main thread: there, a canvas waits for idle time, up to a second in background tabs. */
export interface JpegWorker {
  /**
   * @param picture is closed
   * @param size of the result, and its quality, 0 to 1
   * @returns the file
   */
  encode(picture: ImageBitmap, size: JpegSize): Promise<ArrayBuffer>;
}

export interface JpegSize {
  readonly width: number;
  readonly height: number;
  readonly quality: number;
}

const canvas = new OffscreenCanvas(1, 1);
const context = canvas.getContext('2d', { willReadFrequently: true })!;

async function encode(
  picture: ImageBitmap,
  { width, height, quality }: JpegSize,
): Promise<ArrayBuffer> {
  if (canvas.width !== width) canvas.width = width;
  if (canvas.height !== height) canvas.height = height;
  context.drawImage(picture, 0, 0, width, height);
  picture.close();
  const blob = await canvas.convertToBlob({ type: 'image/jpeg', quality });
  return blob.arrayBuffer();
}

serveCalls<JpegWorker>({
  async encode(picture, size) {
    try {
      return transfer(await encode(picture, size));
    } catch (cause) {
      throw new Error('The browser could not encode the picture.', { cause });
    }
  },
});
