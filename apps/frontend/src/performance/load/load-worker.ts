/** Worker of the load test, which runs its clients, so that rendering of the page does not slow them down. */
import { createClient, type UbiiClient } from '@ubii/client-web';
import { Image2DDataFormat } from '@ubii/proto';
import { systemClock } from '@ubii/timing/system';
import { serveCalls } from '@ubii/worker-rpc/browser';
import type { Findings } from '../measure/findings.ts';
import type { LoadParameters } from './load-parameters.ts';
import { measureLoad, type LoadClient } from './measure-load.ts';
import type { LoadPage, LoadWorker } from './worker-messages.ts';

const stop = new AbortController();
const REPORT_MS = 250;

const page: LoadPage = serveCalls<LoadWorker, LoadPage>({
  run,
  stop: async () => stop.abort(),
});

async function run(url: string, parameters: LoadParameters): Promise<Findings> {
  const opened: UbiiClient[] = [];
  try {
    for (let index = 0; index < parameters.clients; index++) {
      const client = createClient({
        url,
        name: `Load test ${index + 1}`,
        description: 'A test of the performance page',
        tags: ['performance test'],
        publishIntervalMs: 0,
      });
      await client.connect();
      opened.push(client);
      page.addClient(client.id);
    }
    const clients = await connectAll(opened, parameters);
    let reportedMs = -Infinity;
    const findings = await measureLoad(
      parameters,
      {
        clients,
        masterCpuPercent: async () =>
          (await opened[0]!.call('masterStatus', { sinceMs: Date.now() })).cpuPercent,
      },
      {
        clock: systemClock,
        signal: stop.signal,
        report(progress) {
          const nowMs = performance.now();
          if (nowMs - reportedMs < REPORT_MS) return;
          reportedMs = nowMs;
          page.showProgress(progress);
        },
      },
    );
    await leave(opened);
    return findings;
  } catch (cause) {
    await leave(opened);
    throw cause;
  }
}

async function leave(opened: readonly UbiiClient[]): Promise<void> {
  for (const client of opened) {
    await client.close();
    page.removeClient(client.id);
  }
}

/** Each client publishes on its own topic, and subscribes to the topics of its senders. */
async function connectAll(
  opened: readonly UbiiClient[],
  { sizeBytes, receivers }: LoadParameters,
): Promise<LoadClient[]> {
  const topics = opened.map(({ id }) => `/${id}/performance/load`);
  return Promise.all(
    opened.map(async (client, index): Promise<LoadClient> => {
      const before = topics[(index + topics.length - 1) % topics.length]!;
      const heard = receivers === 'all' ? topics : [before];
      const subscriptions = heard.map((topic) => client.subscribe(topic, { format: 'image2D' }));
      await Promise.all(subscriptions.map(({ ready }) => ready));
      const { value, write } = numberedBytes(sizeBytes);
      return {
        publish(sequence, isLast) {
          write(index, sequence);
          client.publish(topics[index]!, 'image2D', value, { immediate: isLast });
        },
        onRecord(fn) {
          for (const subscription of subscriptions) {
            subscription.onRecord(({ value: { data } }) => {
              const view = new DataView(data.buffer, data.byteOffset);
              fn(view.getUint16(0), view.getUint32(2));
            });
          }
        },
      };
    }),
  );
}

/** A value of any size: a picture of one row, with the numbers in its first bytes. */
function numberedBytes(sizeBytes: number) {
  const data = new Uint8Array(sizeBytes).fill(0x55);
  const view = new DataView(data.buffer);
  return {
    value: { width: sizeBytes, height: 1, data, dataFormat: Image2DDataFormat.GRAY8 },
    write(publisher: number, sequence: number): void {
      view.setUint16(0, publisher);
      view.setUint32(2, sequence);
    },
  };
}
