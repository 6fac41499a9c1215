import type { JpegReply, JpegTask } from './jpeg-worker.ts';

/** Time after which a worker counts as dead, milliseconds. */
const TIMEOUT_MS = 5000;

/** Encodes JPEG in a dedicated worker, one picture at a time. Close it after use. */
export class JpegEncoder {
  readonly #worker: Worker;
  readonly #failed: Promise<never>;

  constructor() {
    this.#worker = new Worker(new URL('./jpeg-worker.ts', import.meta.url), { type: 'module' });
    this.#failed = new Promise((_, reject) => {
      this.#worker.onerror = () =>
        reject(new Error('The picture encoder could not start. Reload the page.'));
    });
    this.#failed.catch(() => undefined); // Reported with the next picture.
  }

  static isSupported(): boolean {
    return typeof OffscreenCanvas !== 'undefined' && 'convertToBlob' in OffscreenCanvas.prototype;
  }

  /**
   * @param picture is transferred
   * @throws {Error} if the worker cannot encode
   */
  async encode(
    picture: ImageBitmap,
    options: { readonly width: number; readonly height: number; readonly quality: number },
  ): Promise<Uint8Array<ArrayBuffer>> {
    let timer: ReturnType<typeof setTimeout> | undefined;
    const made = new Promise<JpegReply>((resolve, reject) => {
      this.#worker.onmessage = ({ data }: MessageEvent<JpegReply>) => resolve(data);
      const isGone = (): void =>
        reject(new Error('The picture encoder does not answer. Reload the page.'));
      timer = setTimeout(isGone, TIMEOUT_MS);
      const task: JpegTask = { picture, ...options };
      this.#worker.postMessage(task, [picture]);
    });
    const file = await Promise.race([made, this.#failed]).finally(() => clearTimeout(timer));
    if (!file) throw new Error('The browser could not encode the picture.');
    return new Uint8Array(file);
  }

  close(): void {
    this.#worker.terminate();
  }
}
