import { setTimeout as sleep } from 'node:timers/promises';
import { brokerSubjects } from '../brokers/brokers.ts';
import { REFERENCE, type Access } from '../brokers/target.ts';
import { DeliveryVerifier } from '../load/delivery-verifier.ts';
import { createRecordRing, type RecordRing } from '../load/record-ring.ts';
import { percentile } from '../statistics.ts';
import { WEB_SOCKET } from '../load/wire.ts';
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
      key: 'p999Us',
      label: 'p99.9',
      unit: 'µs',
      isHigherBetter: false,
      goals: { 'ubii-extension': 1.3, 'ubii-legacy': 1.3 },
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

/** One measurement with a single client. */
export function measureRoundTrip(
  target: Access,
  ring: RecordRing,
  options: MeasureOptions,
): Promise<Measurement> {
  return measureLegs([{ access: target, ring }], target.pids, options);
}

/** Part of a round trip: from one client to the next. */
export interface Leg {
  /** Where the receiving client is. */
  readonly access: Access;
  /** Records that travel on it. */
  readonly ring: RecordRing;
}

/**
 * One measurement. The client at the end of a leg publishes the same record number on the next leg; the client at the
 * end of the last one begins again.
 *
 * @param pids processes whose CPU time is counted
 */
export async function measureLegs(
  legs: readonly Leg[],
  pids: readonly number[],
  { warmUpMs, measureMs }: MeasureOptions,
): Promise<Measurement> {
  const stops = await Promise.all(legs.map(openStop));
  const first = stops.at(-1)!;
  const samples = new Float64Array(MAX_SAMPLES);
  let sampleCount = 0;
  let isSampling = false;
  let isRunning = true;
  let sent = 0;
  let sentAtMs = 0;
  let onIdle: () => void = () => {};

  const publish = (): void => {
    const frame = stops[0]!.tape.slice(sent, 1);
    sent += 1;
    sentAtMs = performance.now();
    first.client.connection.send(frame);
  };
  for (const [index, stop] of stops.slice(0, -1).entries()) {
    const { tape } = stops[index + 1]!;
    let passed = 0;
    stop.verifier.onProgress = () => {
      for (; passed < stop.verifier.next; passed += 1) {
        stop.client.connection.send(tape.slice(passed, 1));
      }
    };
  }
  first.verifier.onProgress = () => {
    if (first.verifier.next < sent) return;
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
  const stopLap = startLap(pids);
  isSampling = true;
  await sleep(measureMs);
  isSampling = false;
  const lap = stopLap();

  const idle = new Promise<void>((resolve) => (onIdle = resolve));
  isRunning = false;
  if (first.verifier.next < sent) {
    await Promise.race([idle, sleep(STALL_MS, undefined, { ref: false })]);
  }
  for (const { verifier } of stops) verifier.finish(sent);
  for (const { client } of stops) await client.leave();

  const sorted = samples.subarray(0, sampleCount).sort();
  return {
    figures: {
      p50Us: percentile(sorted, 0.5),
      p99Us: percentile(sorted, 0.99),
      p999Us: percentile(sorted, 0.999),
      cpuUs: lap.cpuUs / sampleCount,
      loadCpu: lap.loadCpuShare,
    },
    otherCpuShare: lap.otherCpuShare,
    deliveries: sampleCount,
    faults: describeFaults(stops.map(({ verifier }) => verifier.faults)),
  };
}

/** Client at the end of a leg, with what is published on that leg. */
async function openStop({ access, ring }: Leg) {
  const verifier = new DeliveryVerifier(ring, access.wire);
  const client = await access.join({ publishes: true, topics: [ring.topic] }, verifier);
  return { verifier, client, tape: (access.wire ?? WEB_SOCKET).published(ring) };
}
