import { setTimeout as sleep } from 'node:timers/promises';
import {
  HAS_HAPROXY,
  startHaproxy,
  startMasterCluster,
  startOneMaster,
  type MasterSet,
} from '../brokers/master-set.ts';
import { joinMaster } from '../brokers/brokers.ts';
import { mainThreadCpuUs, processCpuUs } from '../cpu-time.ts';
import { DeliveryVerifier } from '../load/delivery-verifier.ts';
import { PacedRoom, type Join } from './paced-room.ts';
import { createRecordRing, type RecordRing } from '../load/record-ring.ts';
import { startLap } from '../measuring/stopwatch.ts';
import {
  describeFaults,
  type FigureInfo,
  type Measurement,
  type MeasureOptions,
  type Subject,
  type Workload,
  type WorkloadSetting,
} from '../measuring/workload.ts';

const ONE = 'one master';
const PROXIED = 'one behind haproxy';
const APART = 'two, rooms apart';
const MIXED = 'two, rooms mixed';
const MASTERS = 2;
/** Different records of a room; more than can be under way at once. */
const RING_RECORDS = 512;
/** Until every master knows what the others want. */
const SETTLE_MS = 1_000;
const PACE_MS = 2;
const JOIN_AT_ONCE = 10;
/** Of clients to whom nothing is sent. */
const UNUSED = createRecordRing('cores-connecting', 100, 1);

/** Masters, and the master of each client of a room. */
interface Layout {
  readonly set: MasterSet;
  /** Index of the master, of client number `client` in room number `room`; the publisher is number 0. */
  placeOf(room: number, client: number): number;
  /** Address of the connections instead of the one of the master. */
  readonly origin?: string;
}

interface Rooms {
  readonly name: string;
  readonly title: string;
  readonly rooms: number;
  readonly subscribers: number;
  /** Records a second that the publisher of each room sends. */
  readonly perSecond: number;
}

const FIGURES: readonly FigureInfo[] = [
  figure('cpuUs', 'CPU a delivery, masters and helpers', 'µs'),
  figure('busiestUs', 'main thread of the busiest master', 'µs'),
  figure('helpersUs', 'helpers (NATS, proxy)', 'µs'),
  { ...figure('deliveriesPerS', 'deliveries', '1/s'), isHigherBetter: true },
];

function figure(key: string, label: string, unit: string): FigureInfo {
  return { key, label, unit, isHigherBetter: false, goals: {} };
}

/** The same load on one master, and on two of one cluster: what a second core costs and brings. */
export const CORES: readonly Workload[] = [
  workload({
    name: 'cores-fan-out',
    title: '8 rooms, 1 -> 25, 100 B record, 800 records/s each',
    rooms: 8,
    subscribers: 25,
    perSecond: 800,
  }),
  workload({
    name: 'cores-own-topics',
    title: '100 clients with own topics and one subscriber each, 100 B record, 120 records/s each',
    rooms: 100,
    subscribers: 1,
    perSecond: 120,
  }),
  {
    name: 'cores-connecting',
    group: 'cores',
    title: 'Connecting and subscribing to a topic of its own, and leaving again, 10 at a time',
    figures: [
      figure('cpuUs', 'CPU a client, masters and helpers', 'µs'),
      figure('busiestUs', 'main thread of the busiest master', 'µs'),
      figure('helpersUs', 'helpers (NATS, proxy)', 'µs'),
      { ...figure('deliveriesPerS', 'clients', '1/s'), isHigherBetter: true },
    ],
    reference: ONE,
    placement: 'anywhere',
    roundShare: 1 / 3,
    open: (setting) => subjects(setting, measureConnecting),
  },
];

function workload(rooms: Rooms): Workload {
  return {
    name: rooms.name,
    group: 'cores',
    title: rooms.title,
    figures: FIGURES,
    reference: ONE,
    placement: 'anywhere',
    roundShare: 1 / 3,
    open: async (setting) => {
      const rings = Array.from({ length: rooms.rooms }, (_, room) =>
        createRecordRing(`${rooms.name}-${room}`, 100, RING_RECORDS),
      );
      return subjects(setting, (layout, options) => measureRooms(rooms, rings, layout, options));
    },
  };
}

async function subjects(
  setting: WorkloadSetting,
  measure: (layout: Layout, options: MeasureOptions) => Promise<Measurement>,
): Promise<Subject[]> {
  return (await openLayouts(setting)).map(([name, layout]) => ({
    name,
    pids: pidsOf(layout.set),
    measure: (options) => measure(layout, options),
  }));
}

function pidsOf({ masters, helpers }: Omit<MasterSet, 'stop'>): number[] {
  return [...masters.map(({ pid }) => pid), ...helpers];
}

async function openLayouts({
  parts,
  master,
  profileDir,
}: WorkloadSetting): Promise<(readonly [Subject['name'], Layout])[]> {
  const start = { program: master, profileDir };
  const one = await parts.get('one', () => startOneMaster(start));
  const two = await parts.get('two', () => startMasterCluster(start, MASTERS));
  const layouts: (readonly [string, Layout])[] = [
    [ONE, { set: one, placeOf: () => 0 }],
    [APART, { set: two, placeOf: (room) => room % MASTERS }],
    [MIXED, { set: two, placeOf: (room, client) => (room + client) % MASTERS }],
  ];
  if (HAS_HAPROXY) {
    const proxy = await parts.get('haproxy', () =>
      startHaproxy(Number(new URL(one.masters[0]!.url).port)),
    );
    const set = { ...one, helpers: [proxy.pid] };
    layouts.push([PROXIED, { set, placeOf: () => 0, origin: proxy.origin }]);
  }
  return layouts;
}

async function measureRooms(
  { subscribers, perSecond }: Rooms,
  rings: readonly RecordRing[],
  layout: Layout,
  { warmUpMs, measureMs }: MeasureOptions,
): Promise<Measurement> {
  const rooms: PacedRoom[] = [];
  for (const [room, ring] of rings.entries()) {
    const joins = Array.from({ length: subscribers + 1 }, (_, client) =>
      joinAt(layout, layout.placeOf(room, client)),
    );
    rooms.push(await PacedRoom.open(ring, perSecond, joins));
  }
  await sleep(SETTLE_MS);
  const stopPace = startPace(rooms);
  await sleep(warmUpMs);
  const delivered = (): number => rooms.reduce((sum, room) => sum + room.delivered, 0);
  const before = delivered();
  const stop = startClocks(layout.set);
  await sleep(measureMs);
  const deliveries = delivered() - before;
  const { figures, ...rest } = stop(deliveries);
  stopPace();
  const faults = (await Promise.all(rooms.map((room) => room.close()))).flat();
  return { figures, ...rest, deliveries, faults: describeFaults(faults) };
}

async function measureConnecting(
  layout: Layout,
  { warmUpMs, measureMs }: MeasureOptions,
): Promise<Measurement> {
  const verifiers: DeliveryVerifier[] = [];
  let number = 0;
  const comeAndGo = async (): Promise<void> => {
    number += 1;
    const verifier = new DeliveryVerifier(UNUSED);
    verifiers.push(verifier);
    const role = { publishes: false, topics: [`${UNUSED.topic}/${number}`] };
    const client = await joinAt(layout, layout.placeOf(number, 0))(role, verifier);
    await client.leave();
  };
  const comeAndGoFor = async (ms: number): Promise<number> => {
    const endMs = performance.now() + ms;
    const before = number;
    while (performance.now() < endMs) {
      await Promise.all(Array.from({ length: JOIN_AT_ONCE }, comeAndGo));
    }
    return number - before;
  };
  await comeAndGoFor(warmUpMs);
  const stop = startClocks(layout.set);
  const clients = await comeAndGoFor(measureMs);
  return {
    ...stop(clients),
    deliveries: clients,
    faults: describeFaults(verifiers.map(({ faults }) => faults)),
  };
}

function joinAt({ set, origin }: Layout, place: number): Join {
  const master = set.masters[place]!;
  const { topicDataWs } = master.endpoints;
  const url = origin === undefined ? topicDataWs : origin + new URL(topicDataWs).pathname;
  return (role, receiver) => joinMaster(master, role, receiver, true, url);
}

/** Rooms take their turns at different moments, as people do. */
function startPace(rooms: readonly PacedRoom[]): () => void {
  const startMs = performance.now();
  let turn = 0;
  const timer = setInterval(() => {
    turn += 1;
    const elapsedMs = performance.now() - startMs;
    for (let room = turn % PACE_MS; room < rooms.length; room += PACE_MS)
      rooms[room]!.publishUntil(elapsedMs);
  }, 1);
  return () => clearInterval(timer);
}

function startClocks({ masters, helpers }: Omit<MasterSet, 'stop'>) {
  const mainBefore = masters.map(({ pid }) => mainThreadCpuUs(pid));
  const helpersUs = (): number => helpers.reduce((sum, pid) => sum + processCpuUs(pid), 0);
  const helpersBefore = helpersUs();
  const stopLap = startLap(pidsOf({ masters, helpers }));
  return (deliveries: number): Omit<Measurement, 'deliveries' | 'faults'> => {
    const lap = stopLap();
    const main = masters.map(({ pid }, index) => mainThreadCpuUs(pid) - mainBefore[index]!);
    return {
      figures: {
        cpuUs: lap.cpuUs / deliveries,
        busiestUs: Math.max(...main) / deliveries,
        helpersUs: (helpersUs() - helpersBefore) / deliveries,
        deliveriesPerS: deliveries / (lap.wallUs / 1e6),
      },
      otherCpuShare: lap.otherCpuShare,
    };
  };
}
