import type { UbiiClient } from '@ubii/client-web';
import { callWorker } from '@ubii/worker-rpc/browser';
import { NO_FINDINGS, type Findings } from '../measure/findings.ts';
import type { TestRun } from '../measure/test-run.ts';
import type { Leavings } from '../run/leavings.ts';
import type { LoadParameters } from './load-parameters.ts';
import type { LoadPage, LoadWorker } from './worker-messages.ts';

/** Time after which a worker that does not stop is terminated, milliseconds. */
const STOP_TIMEOUT_MS = 5000;

/** Runs the load test in a worker, and removes its clients afterwards. */
export async function runLoad(
  parameters: LoadParameters,
  client: Pick<UbiiClient, 'call'>,
  leavings: Leavings,
  { clock, signal, report }: TestRun,
): Promise<Findings> {
  const joined = new Set<string>();
  const of = (id: string) => ({ kind: 'client', id }) as const;
  let latest: Findings = NO_FINDINGS;
  const worker = callWorker<LoadWorker, LoadPage>(
    new Worker(new URL('./load-worker.ts', import.meta.url), { type: 'module' }),
    {
      addClient(id) {
        joined.add(id);
        leavings.add(of(id));
      },
      removeClient(id) {
        joined.delete(id);
        leavings.drop(of(id));
      },
      showProgress(progress) {
        latest = progress.findings ?? latest;
        report(progress);
      },
    },
    (message) => `The load generator failed: ${message || 'it could not be loaded'}.`,
  );
  const stopped = new Promise<Findings>((resolve) => {
    signal.addEventListener('abort', () => {
      worker.calls.stop().catch(() => undefined); // `run` says why.
      clock.after(STOP_TIMEOUT_MS, () => resolve(latest));
    });
  });
  try {
    return await Promise.race([worker.calls.run(location.origin, parameters), stopped]);
  } finally {
    worker.close();
    // Remove clients that the worker could not remove itself.
    for (const id of joined) {
      await client.call('clientDeregistration', { id }).then(
        () => leavings.drop(of(id)),
        () => undefined, // Already removed; otherwise it is removed on the next visit.
      );
    }
  }
}
