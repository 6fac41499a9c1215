import { setTimeout as sleep } from 'node:timers/promises';
import { MasterProcess } from '@ubii/harness';
import { encodeRecord } from '@ubii/proto';
import type { BrokerClient, ClientRole } from '../brokers/target.ts';
import { joinMaster } from '../brokers/brokers.ts';
import { mainThreadCpuUs } from '../cpu-time.ts';
import { DeliveryVerifier } from '../load/delivery-verifier.ts';
import { OPCODE, clientFrame } from '../load/frames.ts';
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
/** Records that are published before the master is waited for. */
const BATCH = 100;
/** Most batches before and in a measurement: together fewer topics than a client may have (limit `topicsPerClient`). */
const WARM_UP_BATCHES = 300;
const MEASURED_BATCHES = 1_000;
const STALL_MS = 2_000;
const TOPIC_DATA_RECORD_TAG = 0x12;

/** Records of topics that are new, or that were published before, while another client subscribes to patterns that match none. */
function amongPatterns(
  name: string,
  title: string,
  { goal, nextTopic }: { goal: number; nextTopic: () => string },
): Workload {
  return {
    name,
    group: 'connections',
    title: `${title} among ${PATTERNS} patterns that do not match`,
    figures: [
      {
        key: 'cpuUs',
        label: 'CPU a record, main thread',
        unit: 'µs',
        isHigherBetter: false,
        goals: { [WITH]: goal },
      },
    ],
    placement: 'core-each',
    reference: WITHOUT,
    roundShare: 1 / 3,
    open: async ({ parts, master: file, profileDir }) => {
      const master = await parts.get('master', () =>
        MasterProcess.start({ program: file, profileDir }),
      );
      return [WITHOUT, WITH].map((subject) => ({
        name: subject,
        pids: [master.pid],
        measure: (options) => measure(master, subject === WITH, nextTopic, options),
      }));
    },
  };
}

let topics = 0;

export const firstPublish = amongPatterns('first-publish', 'First record of a topic', {
  goal: 1.7,
  nextTopic: () => `/first/${(topics += 1)}`,
});

export const laterPublish = amongPatterns('later-publish', 'Later records of a topic', {
  goal: 1.05,
  nextTopic: () => '/later',
});

function frameOf(topic: string): Buffer {
  const record = encodeRecord({ topic, format: 'double', value: 1 });
  const message = [TOPIC_DATA_RECORD_TAG, record.length];
  return clientFrame(OPCODE.binary, Buffer.concat([Buffer.from(message), record]));
}

async function measure(
  master: MasterProcess,
  withPatterns: boolean,
  nextTopic: () => string,
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
      const frames = Array.from({ length: BATCH }, () => frameOf(nextTopic()));
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
