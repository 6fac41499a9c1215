import type { UbiiClient } from '@ubii/client-web';
import { NO_FINDINGS, type Findings } from '../measure/findings.ts';
import type { TestRun } from '../measure/test-run.ts';
import type { Leavings } from '../run/leavings.ts';
import type { LoadParameters } from './load-parameters.ts';
import type { FromLoadWorker, ToLoadWorker } from './worker-messages.ts';

/** Time after which a worker that does not stop is terminated, milliseconds. */
const STOP_TIMEOUT_MS = 5000;

/** Runs the load test in a worker, and removes its clients afterwards. */
export async function runLoad(
  parameters: LoadParameters,
  client: Pick<UbiiClient, 'call'>,
  leavings: Leavings,
  { clock, signal, report }: TestRun,
): Promise<Findings> {
  const worker = new Worker(new URL('./load-worker.ts', import.meta.url), { type: 'module' });
  const send = (message: ToLoadWorker): void => worker.postMessage(message);
  const joined = new Set<string>();
  const of = (id: string) => ({ kind: 'client', id }) as const;
  let latest: Findings = NO_FINDINGS;
  try {
    return await new Promise<Findings>((resolve, reject) => {
      worker.onmessage = ({ data }: MessageEvent<FromLoadWorker>) => {
        switch (data.kind) {
          case 'joined':
            joined.add(data.clientId);
            leavings.add(of(data.clientId));
            return;
          case 'left':
            joined.delete(data.clientId);
            leavings.drop(of(data.clientId));
            return;
          case 'progress':
            latest = data.progress.findings ?? latest;
            report(data.progress);
            return;
          case 'done':
            resolve(data.findings);
            return;
          case 'failed':
            reject(new Error(data.reason));
        }
      };
      worker.onerror = ({ message }) =>
        reject(new Error(`The load generator failed: ${message || 'it could not be loaded'}.`));
      signal.addEventListener('abort', () => {
        send({ kind: 'stop' });
        clock.after(STOP_TIMEOUT_MS, () => resolve(latest));
      });
      send({ kind: 'start', url: location.origin, parameters });
    });
  } finally {
    worker.terminate();
    // Remove clients that the worker could not remove itself.
    for (const id of joined) {
      await client.call('clientDeregistration', { id }).then(
        () => leavings.drop(of(id)),
        () => undefined, // Already removed; otherwise it is removed on the next visit.
      );
    }
  }
}
