import type { JpegReply, JpegTask } from './jpeg-worker.ts';

/** Makes JPEG files in a worker of its own, one at a time. Close it when it is not used any more. */
export class JpegEncoder {
  readonly #worker = new Worker(new URL('./jpeg-worker.ts', import.meta.url), { type: 'module' });

  static isSupported(): boolean {
    return typeof OffscreenCanvas !== 'undefined' && 'convertToBlob' in OffscreenCanvas.prototype;
  }

  /**
   * @param picture is given away
   * @throws {Error} if the browser makes no JPEG in a worker
   */
  async encode(
    picture: ImageBitmap,
    options: { readonly width: number; readonly height: number; readonly quality: number },
  ): Promise<Uint8Array<ArrayBuffer>> {
    const file = await new Promise<JpegReply>((resolve, reject) => {
      this.#worker.onmessage = ({ data }: MessageEvent<JpegReply>) => resolve(data);
      this.#worker.onerror = () => reject(new Error('The worker of pictures could not start.'));
      const task: JpegTask = { picture, ...options };
      this.#worker.postMessage(task, [picture]);
    });
    if (!file) throw new Error('The browser could not encode the picture.');
    return new Uint8Array(file);
  }

  close(): void {
    this.#worker.terminate();
  }
}
