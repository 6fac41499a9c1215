import { Worker } from 'node:worker_threads';

/** One request that is sent all the time. */
export interface SentBody {
  /** Of the service, as JSON. */
  readonly url: string;
  readonly headers: Readonly<Record<string, string>>;
  readonly body: string;
}

export interface BodySender {
  /** Ends it after the request under way. @returns how many were sent, and the last answer */
  stop(): Promise<{ readonly answers: number; readonly last: string }>;
}

/** Starts a thread that sends it, see body-sender.mjs. */
export function startBodySender(sent: SentBody): BodySender {
  const worker = new Worker(new URL('./body-sender.mjs', import.meta.url), {
    workerData: sent,
    execArgv: [],
  });
  const result = new Promise<{ answers: number; last: string }>((resolve, reject) => {
    worker.once('message', resolve);
    worker.once('error', reject);
  });
  return {
    stop: () => {
      worker.postMessage('stop');
      return result;
    },
  };
}
