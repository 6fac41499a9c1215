import { setTimeout as sleep } from 'node:timers/promises';
import { brokerSubjects } from '../brokers/open-brokers.ts';
import { REFERENCE, type Target } from '../brokers/target.ts';
import { DeliveryVerifier } from '../load/delivery-verifier.ts';
import { createRecordRing, type RecordRing } from '../load/record-ring.ts';
import { percentile } from '../statistics.ts';
import { startLap } from '../measuring/stopwatch.ts';
import {
  describeFaults,
  type Measurement,
  type MeasureOptions,
  type Workload,
} from '../measuring/workload.ts';

const RECORD_BYTES = 100;
/** No answer for so long: the record is lost. */
const STALL_MS = 2_000;
/** Room for the samples of the fastest broker and the longest run. */
const MAX_SAMPLES = 4_000_000;

/** One client publishes a record, waits until it is back, publishes the next. */
export const roundTrip: Workload = {
  name: 'round-trip',
  group: 'round-trip',
  title: `Round trip, ${RECORD_BYTES} B record, closed loop`,
  figures: [
    {
      key: 'p50Us',
      label: 'p50',
      unit: 'µs',
      isHigherBetter: false,
      goals: { 'ubii-extension': 1.15, 'ubii-legacy': 1.15 },
    },
    {
      key: 'p99Us',
      label: 'p99',
      unit: 'µs',
      isHigherBetter: false,
      goals: { 'ubii-extension': 1.2, 'ubii-legacy': 1.2 },
    },
    {
      key: 'cpuUs',
      label: 'broker CPU a message',
      unit: 'µs',
      isHigherBetter: false,
      goals: { 'ubii-extension': 1.25, 'ubii-legacy': 1.25 },
    },
    {
      key: 'loadCpu',
      label: 'load generator CPU',
      unit: 'cores',
      isHigherBetter: false,
      goals: {},
    },
  ],
  // Only one of the two processes has work at a time. On two cores each message would wake a sleeping
  // core twice, which takes longer than everything the brokers do, and not always equally long.
  placement: 'one-core',
  reference: REFERENCE,
  roundShare: 1,
  open: (setting) => {
    const ring = createRecordRing('round-trip', RECORD_BYTES);
    return brokerSubjects(setting, (target, options) => measureRoundTrip(target, ring, options));
  },
};

/** One measurement. */
export async function measureRoundTrip(
  target: Target,
  ring: RecordRing,
  { warmUpMs, measureMs }: MeasureOptions,
): Promise<Measurement> {
  const verifier = new DeliveryVerifier(ring);
  const client = await target.join({ publishes: true, topics: [ring.topic] }, verifier);
  const { connection } = client;
  const samples = new Float64Array(MAX_SAMPLES);
  let sampleCount = 0;
  let isSampling = false;
  let isRunning = true;
  let sent = 0;
  let sentAtMs = 0;
  let onIdle: () => void = () => {};

  const publish = (): void => {
    const frame = ring.published.slice(sent, 1);
    sent += 1;
    sentAtMs = performance.now();
    connection.send(frame);
  };
  verifier.onProgress = () => {
    if (verifier.next < sent) return;
    const tookMs = performance.now() - sentAtMs;
    if (isSampling && sampleCount < MAX_SAMPLES) {
      samples[sampleCount] = tookMs * 1000;
      sampleCount += 1;
    }
    if (isRunning) publish();
    else onIdle();
  };

  publish();
  await sleep(warmUpMs);
  const stopLap = startLap([target.pid]);
  isSampling = true;
  await sleep(measureMs);
  isSampling = false;
  const lap = stopLap();

  const idle = new Promise<void>((resolve) => (onIdle = resolve));
  isRunning = false;
  if (verifier.next < sent) await Promise.race([idle, sleep(STALL_MS, undefined, { ref: false })]);
  verifier.finish(sent);
  await client.leave();

  const sorted = samples.subarray(0, sampleCount).sort();
  return {
    figures: {
      p50Us: percentile(sorted, 0.5),
      p99Us: percentile(sorted, 0.99),
      cpuUs: lap.cpuUs / sampleCount,
      loadCpu: lap.loadCpuShare,
    },
    otherCpuShare: lap.otherCpuShare,
    deliveries: sampleCount,
    faults: describeFaults([verifier.faults]),
  };
}
