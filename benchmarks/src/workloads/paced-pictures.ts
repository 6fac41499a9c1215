import { setTimeout as sleep } from 'node:timers/promises';
import { brokerSubjects } from '../brokers/brokers.ts';
import { REFERENCE, type Access } from '../brokers/target.ts';
import { DeliveryVerifier } from '../load/delivery-verifier.ts';
import { createPictureRing, type RecordRing } from '../load/record-ring.ts';
import { WEB_SOCKET } from '../load/wire.ts';
import { startLap } from '../measuring/stopwatch.ts';
import {
  describeFaults,
  type Measurement,
  type MeasureOptions,
  type Workload,
} from '../measuring/workload.ts';
import { percentile } from '../statistics.ts';

const OURS = 'ubii-extension';
const PICTURE_BYTES = 100_000;
const SUBSCRIBERS = 10;
const PER_SECOND = 30;
/** Shorter than the ring lasts at this rate. */
const SETTLE_MS = 500;

/** Pictures of a camera, as often as it makes them: the broker waits most of the time. */
export const pacedPictures: Workload = {
  name: 'paced-pictures',
  group: 'fan-out',
  title: `Pictures of ${PICTURE_BYTES / 1000} kB at ${PER_SECOND} Hz to ${SUBSCRIBERS}`,
  figures: [
    {
      key: 'cpuMsPerMb',
      label: 'broker CPU a MB',
      unit: 'ms',
      isHigherBetter: false,
      goals: { [OURS]: 1.1 },
    },
    { key: 'p50Ms', label: 'p50', unit: 'ms', isHigherBetter: false, goals: {} },
    {
      key: 'p99Ms',
      label: 'p99',
      unit: 'ms',
      isHigherBetter: false,
      goals: { [OURS]: 1.1 },
    },
  ],
  placement: 'core-each',
  reference: REFERENCE,
  roundShare: 1,
  open: (setting) => {
    const ring = createPictureRing('paced-pictures', PICTURE_BYTES, PER_SECOND);
    return brokerSubjects(setting, (target, options) => measurePaced(target, ring, options));
  },
};

/** One measurement: how long each picture takes to each subscriber. */
export async function measurePaced(
  target: Access,
  ring: RecordRing,
  { warmUpMs, measureMs }: MeasureOptions,
): Promise<Measurement> {
  const tape = (target.wire ?? WEB_SOCKET).published(ring);
  const published = new DeliveryVerifier(ring, target.wire);
  const publisher = await target.join({ publishes: true, topics: [] }, published);
  const sentMs: number[] = [];
  const tookMs: number[] = [];
  let isSampling = false;
  const subscribers = await Promise.all(
    Array.from({ length: SUBSCRIBERS }, async () => {
      const verifier = new DeliveryVerifier(ring, target.wire);
      const client = await target.join({ publishes: false, topics: [ring.topic] }, verifier);
      let before = 0;
      verifier.onProgress = () => {
        const nowMs = performance.now();
        for (; before < verifier.next; before += 1) {
          if (isSampling) tookMs.push(nowMs - sentMs[before]!);
        }
      };
      return { verifier, client };
    }),
  );

  const startMs = performance.now();
  const timer = setInterval(() => {
    const due = Math.floor(((performance.now() - startMs) / 1000) * PER_SECOND);
    if (sentMs.length >= due) return;
    publisher.connection.send(tape.slice(sentMs.length, 1));
    sentMs.push(performance.now());
  }, 1);
  await sleep(warmUpMs);
  const stopLap = startLap(target.pids);
  isSampling = true;
  await sleep(measureMs);
  isSampling = false;
  const lap = stopLap();
  clearInterval(timer);
  await sleep(SETTLE_MS);

  published.finish(0);
  for (const { verifier } of subscribers) verifier.finish(sentMs.length);
  const verifiers = [published, ...subscribers.map(({ verifier }) => verifier)];
  await Promise.all([publisher, ...subscribers.map(({ client }) => client)].map((c) => c.leave()));
  const sorted = Float64Array.from(tookMs).sort();
  return {
    figures: {
      cpuMsPerMb: lap.cpuUs / 1000 / ((tookMs.length * PICTURE_BYTES) / 1e6),
      p50Ms: percentile(sorted, 0.5),
      p99Ms: percentile(sorted, 0.99),
    },
    otherCpuShare: lap.otherCpuShare,
    deliveries: tookMs.length,
    faults: describeFaults(verifiers.map(({ faults }) => faults)),
  };
}
