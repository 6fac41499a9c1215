import { callWorker, transfer, type WorkerPeer } from '@ubii/worker-rpc/browser';
import type { JpegSize, JpegWorker } from './jpeg-worker.ts';

/** Time after which a worker counts as dead, milliseconds. */
const TIMEOUT_MS = 5000;

/** Encodes JPEG in a dedicated worker, one picture at a time. Close it after use. */
export class JpegEncoder {
  readonly #worker: WorkerPeer<JpegWorker> = callWorker(
    new Worker(new URL('./jpeg-worker.ts', import.meta.url), { type: 'module' }),
    {},
    'The picture encoder could not start. Reload the page.',
  );

  static isSupported(): boolean {
    return typeof OffscreenCanvas !== 'undefined' && 'convertToBlob' in OffscreenCanvas.prototype;
  }

  /**
   * @param picture is transferred
   * @throws {Error} if the worker cannot encode
   */
  async encode(picture: ImageBitmap, size: JpegSize): Promise<Uint8Array<ArrayBuffer>> {
    let timer: ReturnType<typeof setTimeout> | undefined;
    const late = new Promise<never>((_resolve, reject) => {
      const isGone = (): void =>
        reject(new Error('The picture encoder does not answer. Reload the page.'));
      timer = setTimeout(isGone, TIMEOUT_MS);
    });
    const made = this.#worker.calls.encode(transfer(picture), size);
    return new Uint8Array(await Promise.race([made, late]).finally(() => clearTimeout(timer)));
  }

  close(): void {
    this.#worker.close();
  }
}
