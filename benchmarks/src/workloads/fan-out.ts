import { setTimeout as sleep } from 'node:timers/promises';
import { brokerSubjects } from '../brokers/open-brokers.ts';
import { REFERENCE, type BrokerClient, type Target } from '../brokers/target.ts';
import { DeliveryVerifier } from '../load/delivery-verifier.ts';
import { FlowWindow } from '../load/flow-window.ts';
import { createRecordRing, type RecordRing } from '../load/record-ring.ts';
import { startLap } from '../measuring/stopwatch.ts';
import {
  describeFaults,
  type FigureInfo,
  type Measurement,
  type MeasureOptions,
  type Workload,
} from '../measuring/workload.ts';

const RECORD_BYTES = 100;
const SUBSCRIBERS = 100;
/** Clients that register and connect at the same time. */
const JOIN_AT_ONCE = 10;
/** No record got to all subscribers for so long: what is missing is lost. */
const STALL_MS = 2_000;

/**
 * One client publishes, 100 others receive. A record is done when all of them have it; at most
 * `window` records are not done.
 */
export function fanOut(window: number, goals: FigureInfo['goals']): Workload {
  return {
    name: `fan-out-window-${window}`,
    group: 'fan-out',
    title: `Fan-out 1 -> ${SUBSCRIBERS}, ${RECORD_BYTES} B record, window ${window}`,
    figures: [
      {
        key: 'deliveriesPerS',
        label: 'deliveries',
        unit: '1/s',
        isHigherBetter: true,
        goals,
      },
      {
        key: 'cpuUs',
        label: 'broker CPU a delivery',
        unit: 'µs',
        isHigherBetter: false,
        goals: {},
      },
      {
        key: 'loadCpu',
        label: 'load generator CPU',
        unit: 'cores',
        isHigherBetter: false,
        goals: {},
      },
    ],
    // As it would be with clients on other machines: the broker has a core to itself.
    placement: 'core-each',
    reference: REFERENCE,
    roundShare: 1,
    open: (setting) => {
      const ring = createRecordRing('fan-out', RECORD_BYTES);
      return brokerSubjects(setting, (target, options) =>
        measureFanOut(window, target, ring, options),
      );
    },
  };
}

/** One measurement. */
export async function measureFanOut(
  window: number,
  target: Target,
  ring: RecordRing,
  { warmUpMs, measureMs }: MeasureOptions,
): Promise<Measurement> {
  const subscribers = await joinAll(target, ring);
  const published = new DeliveryVerifier(ring);
  const publisher = await target.join({ publishes: true, topics: [] }, published);
  const flow = new FlowWindow(SUBSCRIBERS, window);
  let delivered = 0;
  let sent = 0;
  let isRunning = true;
  let onIdle: () => void = () => {};

  const publish = (): void => {
    const count = window - (sent - flow.slowest);
    if (count <= 0) return;
    const frames = ring.published.slice(sent, count);
    sent += count;
    publisher.connection.send(frames);
  };
  for (const { verifier } of subscribers) {
    let before = 0;
    verifier.onProgress = () => {
      const now = Math.min(verifier.next, sent);
      if (now === before) return;
      delivered += now - before;
      const isDone = flow.advance(before, now);
      before = now;
      if (!isDone) return;
      if (isRunning) publish();
      else if (flow.slowest === sent) onIdle();
    };
  }

  publish();
  await sleep(warmUpMs);
  const deliveredBefore = delivered;
  const stopLap = startLap([target.pid]);
  await sleep(measureMs);
  const deliveries = delivered - deliveredBefore;
  const lap = stopLap();

  const idle = new Promise<void>((resolve) => (onIdle = resolve));
  isRunning = false;
  if (flow.slowest < sent) await Promise.race([idle, sleep(STALL_MS, undefined, { ref: false })]);
  for (const { verifier } of subscribers) verifier.finish(sent);
  published.finish(0);
  const faults = describeFaults(
    [published, ...subscribers.map(({ verifier }) => verifier)].map((verifier) => verifier.faults),
  );
  await Promise.all([publisher, ...subscribers].map((client) => client.leave()));

  return {
    figures: {
      deliveriesPerS: deliveries / (lap.wallUs / 1e6),
      cpuUs: lap.cpuUs / deliveries,
      loadCpu: lap.loadCpuShare,
    },
    otherCpuShare: lap.otherCpuShare,
    deliveries,
    faults,
  };
}

type Subscriber = BrokerClient & { readonly verifier: DeliveryVerifier };

async function joinAll(target: Target, ring: RecordRing): Promise<Subscriber[]> {
  const clients: Subscriber[] = [];
  while (clients.length < SUBSCRIBERS) {
    const count = Math.min(JOIN_AT_ONCE, SUBSCRIBERS - clients.length);
    const joined = Array.from({ length: count }, async () => {
      const verifier = new DeliveryVerifier(ring);
      const client = await target.join({ publishes: false, topics: [ring.topic] }, verifier);
      return { ...client, verifier };
    });
    clients.push(...(await Promise.all(joined)));
  }
  return clients;
}
