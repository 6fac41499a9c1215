import { setTimeout as sleep } from 'node:timers/promises';
import { MasterProcess } from '@ubii/harness';
import { encodeRecord } from '@ubii/proto';
import type { BrokerClient, ClientRole } from '../brokers/target.ts';
import { joinMaster } from '../brokers/ubii.ts';
import { mainThreadCpuUs } from '../cpu-time.ts';
import { DeliveryVerifier } from '../load/delivery-verifier.ts';
import { OPCODE } from '../load/frame-reader.ts';
import { clientFrame } from '../load/frames.ts';
import { createRecordRing } from '../load/record-ring.ts';
import { startLap } from '../measuring/stopwatch.ts';
import {
  describeFaults,
  type Measurement,
  type MeasureOptions,
  type Workload,
} from '../measuring/workload.ts';

const PATTERNS = 1000;
const WITHOUT = 'without patterns';
const WITH = `${PATTERNS} patterns`;
/** Topics that are published before the master is waited for. */
const BATCH = 100;
/** Most batches before and in a measurement: together fewer topics than a client may have (limit `topicsPerClient`). */
const WARM_UP_BATCHES = 300;
const MEASURED_BATCHES = 1_000;
const STALL_MS = 2_000;
const TOPIC_DATA_RECORD_TAG = 0x12;

/** First records of new topics, while another client subscribes to patterns that match none of them. */
export const firstPublish: Workload = {
  name: 'first-publish',
  group: 'connections',
  title: `First record of a topic among ${PATTERNS} patterns that do not match`,
  figures: [
    {
      ...{ key: 'cpuUs', label: 'CPU a topic, main thread', unit: 'µs', isHigherBetter: false },
      goals: { [WITH]: 1.7 },
    },
  ],
  placement: 'core-each',
  reference: WITHOUT,
  roundShare: 1 / 3,
  open: async ({ parts, master: file, profileDir }) => {
    const master = await parts.get('master', () =>
      MasterProcess.start({ program: file, profileDir }),
    );
    return [WITHOUT, WITH].map((name) => ({
      name,
      pids: [master.pid],
      measure: (options) => measure(master, name === WITH, options),
    }));
  },
};

let topics = 0;

/** The first record of the next topic that was not used yet. */
function nextFrame(): Buffer {
  topics += 1;
  const record = encodeRecord({ topic: `/first/${topics}`, format: 'double', value: topics });
  const message = [TOPIC_DATA_RECORD_TAG, record.length];
  return clientFrame(OPCODE.binary, Buffer.concat([Buffer.from(message), record]));
}

async function measure(
  master: MasterProcess,
  withPatterns: boolean,
  { warmUpMs, measureMs }: MeasureOptions,
): Promise<Measurement> {
  // Its records follow each batch: when they come, the batch was handled.
  const ring = createRecordRing('first-publish', 100);
  const [verifier, others, published] = [ring, ring, ring].map(
    (each) => new DeliveryVerifier(each),
  );
  const join = (role: Partial<ClientRole>, receiver: DeliveryVerifier): Promise<BrokerClient> =>
    joinMaster(master, { publishes: false, topics: [], ...role }, receiver, true);
  const watcher = await join({ topics: [ring.topic] }, verifier!);
  const patterns = Array.from({ length: withPatterns ? PATTERNS : 0 }, (_, i) => `^/foreign/${i}/`);
  const listener = await join({ patterns }, others!);
  const publisher = await join({ publishes: true }, published!);
  let batches = 0;
  const publishFor = async (ms: number, mostBatches: number): Promise<number> => {
    const endMs = performance.now() + ms;
    const before = batches;
    while (performance.now() < endMs && batches - before < mostBatches) {
      const frames = Array.from({ length: BATCH }, nextFrame);
      const came = new Promise<void>((resolve) => (verifier!.onProgress = resolve));
      publisher.connection.send(Buffer.concat([...frames, ring.published.slice(batches, 1)]));
      batches += 1;
      await Promise.race([came, sleep(STALL_MS, undefined, { ref: false })]);
    }
    return (batches - before) * BATCH;
  };
  await publishFor(warmUpMs, WARM_UP_BATCHES);
  const cpuBeforeUs = mainThreadCpuUs(master.pid);
  const stopLap = startLap([master.pid]);
  const count = await publishFor(measureMs, MEASURED_BATCHES);
  const { otherCpuShare } = stopLap();
  const cpuUs = mainThreadCpuUs(master.pid) - cpuBeforeUs;
  verifier!.finish(batches);
  await Promise.all([watcher, listener, publisher].map((client) => client.leave()));
  return {
    figures: { cpuUs: cpuUs / count },
    otherCpuShare,
    deliveries: count,
    faults: describeFaults([verifier!, others!, published!].map(({ faults }) => faults)),
  };
}
