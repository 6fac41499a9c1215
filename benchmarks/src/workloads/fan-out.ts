import { setTimeout as sleep } from 'node:timers/promises';
import { brokerSubjects } from '../brokers/brokers.ts';
import { REFERENCE, type Access, type BrokerClient } from '../brokers/target.ts';
import { DeliveryVerifier } from '../load/delivery-verifier.ts';
import { FlowWindow } from '../load/flow-window.ts';
import { createPictureRing, createRecordRing, type RecordRing } from '../load/record-ring.ts';
import { WEB_SOCKET } from '../load/wire.ts';
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
/** A frame of a phone's camera. */
const PICTURE_BYTES = 100_000;
const PICTURE_SUBSCRIBERS = 10;
const PICTURES_UNDER_WAY = 4;
/** Clients that register and connect at the same time. */
const JOIN_AT_ONCE = 10;
/** No record got to all subscribers for so long: what is missing is lost. */
const STALL_MS = 2_000;

export interface FanOut {
  readonly name: string;
  readonly title: string;
  readonly subscribers: number;
  /** Records that at most are not with all subscribers. */
  readonly window: number;
  createRing(): RecordRing;
}

/** One client publishes, 100 others receive small records. */
function fanOut(window: number): FanOut {
  return {
    name: `fan-out-window-${window}`,
    title: `Fan-out 1 -> ${SUBSCRIBERS}, ${RECORD_BYTES} B record, window ${window}`,
    subscribers: SUBSCRIBERS,
    window,
    createRing: () => createRecordRing('fan-out', RECORD_BYTES),
  };
}

export const FAN_OUT_64 = fanOut(64);
export const FAN_OUT_1 = fanOut(1);

/** One client publishes compressed pictures, 10 others receive them. */
export const FAN_OUT_PICTURES: FanOut = {
  name: 'fan-out-pictures',
  title: `Fan-out 1 -> ${PICTURE_SUBSCRIBERS}, picture of ${PICTURE_BYTES / 1000} kB, window ${PICTURES_UNDER_WAY}`,
  subscribers: PICTURE_SUBSCRIBERS,
  window: PICTURES_UNDER_WAY,
  createRing: () => createPictureRing('pictures', PICTURE_BYTES, 4 * PICTURES_UNDER_WAY),
};

/** To our brokers and the bare one. */
export const FAN_OUTS: readonly Workload[] = [
  fanOutWorkload(FAN_OUT_64, { 'ubii-extension': 0.85, 'ubii-legacy': 0.7 }),
  fanOutWorkload(FAN_OUT_1, { 'ubii-extension': 0.95, 'ubii-legacy': 0.95 }),
  fanOutWorkload(FAN_OUT_PICTURES, { 'ubii-extension': 0.95, 'ubii-legacy': 0.95 }),
];

/**
 * A record is done when all subscribers have it; at most `window` records are not done.
 * @param goals of the deliveries a second
 */
export function fanOutWorkload(fan: FanOut, goals: FigureInfo['goals']): Workload {
  return {
    name: fan.name,
    group: 'fan-out',
    title: fan.title,
    figures: [
      { key: 'deliveriesPerS', label: 'deliveries', unit: '1/s', isHigherBetter: true, goals },
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
      const ring = fan.createRing();
      return brokerSubjects(setting, (target, options) =>
        measureFanOut(fan, target, ring, options),
      );
    },
  };
}

/** One measurement. */
export async function measureFanOut(
  { subscribers: count, window }: Pick<FanOut, 'subscribers' | 'window'>,
  target: Access,
  ring: RecordRing,
  { warmUpMs, measureMs }: MeasureOptions,
): Promise<Measurement> {
  const subscribers = await joinAll(target, count, ring);
  const published = new DeliveryVerifier(ring, target.wire);
  const tape = (target.wire ?? WEB_SOCKET).published(ring);
  const publisher = await target.join({ publishes: true, topics: [] }, published);
  const flow = new FlowWindow(count, window);
  let delivered = 0;
  let sent = 0;
  let isRunning = true;
  let onIdle: () => void = () => {};

  const publish = (): void => {
    const free = window - (sent - flow.slowest);
    if (free <= 0) return;
    const frames = tape.slice(sent, free);
    sent += free;
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
  const stopLap = startLap(target.pids);
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

async function joinAll(target: Access, count: number, ring: RecordRing): Promise<Subscriber[]> {
  const clients: Subscriber[] = [];
  while (clients.length < count) {
    const next = Math.min(JOIN_AT_ONCE, count - clients.length);
    const joined = Array.from({ length: next }, async () => {
      const verifier = new DeliveryVerifier(ring, target.wire);
      const client = await target.join({ publishes: false, topics: [ring.topic] }, verifier);
      return { ...client, verifier };
    });
    clients.push(...(await Promise.all(joined)));
  }
  return clients;
}
