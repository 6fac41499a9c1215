import { Worker } from 'node:worker_threads';

/** A worker that answers one message at a time, see bare-worker.mjs. */
export interface BareWorker {
  call(message: unknown, transfer: readonly ArrayBuffer[]): Promise<unknown>;
  stop(): Promise<void>;
}

export function startBareWorker(): Promise<BareWorker> {
  const worker = new Worker(new URL('./bare-worker.mjs', import.meta.url), { execArgv: [] });
  let settle: { resolve(answer: unknown): void; reject(error: Error): void } | undefined;
  worker.on('message', (answer) => settle?.resolve(answer));
  worker.on('error', (error: Error) => settle?.reject(error));
  const bare: BareWorker = {
    call: (message, transfer) =>
      new Promise((resolve, reject) => {
        settle = { resolve, reject };
        worker.postMessage(message, transfer);
      }),
    stop: async () => void (await worker.terminate()),
  };
  return new Promise((resolve, reject) => {
    worker.once('error', reject);
    worker.once('online', () => {
      worker.off('error', reject);
      resolve(bare);
    });
  });
}
