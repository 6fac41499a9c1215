import { MasterProcess } from '@ubii/harness';
import {
  accessTo,
  accessToAll,
  startCluster,
  startRelays,
  type NatsPart,
  type RunningCluster,
  type Relays,
} from '../brokers/cluster.ts';
import type { Access } from '../brokers/target.ts';
import { joinMaster } from '../brokers/brokers.ts';
import { createPictureRing, createRecordRing, type RecordRing } from '../load/record-ring.ts';
import {
  warmed,
  type FigureInfo,
  type Measurement,
  type MeasureOptions,
  type Subject,
  type Workload,
  type WorkloadSetting,
} from '../measuring/workload.ts';
import { measureFanOut } from './fan-out.ts';
import { measureLegs, type Leg } from './round-trip.ts';

const NATS = 'nats';
const RELAYS = 'two-relays';
const CLUSTER_SUBJECT = 'ubii-cluster';
const SINGLE = 'ubii-single';
const ALONE = 'alone';
const TOGETHER = 'in a cluster';

/** The figure that shows whether V8 has compiled what runs. */
const CPU_KEY = 'cpuUs';

const SMALL_BYTES = 100;
const LARGE_BYTES = 100_000;
const LARGE_RECORDS = 8;
/**
 * From a client at one master to a client at another one, a record takes two connections, NATS, and two connections
 * again: as many as two passes through NATS. There and back are four.
 */
const PASSES = 4;
const SUBSCRIBERS = 100;
const WINDOW = 64;

/** Across masters beside NATS alone, and within one master of a cluster beside a master without one. */
export const CLUSTER: readonly Workload[] = [
  across('cluster-round-trip', `${SMALL_BYTES} B`, (name) => createRecordRing(name, SMALL_BYTES)),
  across('cluster-round-trip-large', `${LARGE_BYTES / 1000} kB`, (name) =>
    createPictureRing(name, LARGE_BYTES, LARGE_RECORDS),
  ),
  fanOutAcross(),
  localRoundTrip(),
  localFanOut(),
];

function across(name: string, size: string, createRing: (name: string) => RecordRing): Workload {
  return {
    name,
    group: 'cluster',
    reference: NATS,
    placement: 'one-core',
    roundShare: 1,
    title: `Round trip from one master of a cluster to another, ${size} record, closed loop`,
    figures: [
      ...roundTripFigures({ p50Us: { [CLUSTER_SUBJECT]: 1.2 } }),
      besideRelays('p50Us', 'p50 / that of two relays', { [CLUSTER_SUBJECT]: 1.2 }),
      besideRelays('cpuUs', 'broker CPU / that of two relays', {}),
    ],
    derive: deriveBesideRelays,
    open: async (setting) => {
      const cluster = await clusterOf(setting);
      const relays = await relaysOf(setting, cluster.nats);
      const { nats, pids } = cluster;
      const rings = Array.from({ length: PASSES }, (_, index) => createRing(`${name}-${index}`));
      // All are placed, so that those that wait take no time on another core.
      const placed = [...new Set([...pids, ...relays.accesses[0]!.pids])];
      const atMasters = [1, 0].map((index) => accessTo(cluster, index, pids));
      return [
        subject(NATS, placed, legsOf(rings, [nats])),
        subject(RELAYS, placed, legsOf(rings.slice(0, 2), relays.accesses)),
        subject(CLUSTER_SUBJECT, placed, legsOf(rings.slice(0, 2), atMasters)),
      ];
    },
  };
}

/** The cluster's figure divided by that of the relays in the same round. */
function besideRelays(key: string, label: string, bounds: Record<string, number>): FigureInfo {
  return { key: relaysKey(key), label, unit: 'x', isHigherBetter: false, goals: {}, bounds };
}

function relaysKey(key: string): string {
  return `${key}BesideRelays`;
}

function deriveBesideRelays(
  round: Readonly<Record<string, Measurement>>,
): Record<string, Measurement> {
  const cluster = round[CLUSTER_SUBJECT]!;
  const ratios = ['p50Us', 'cpuUs'].map((key): [string, number] => [
    relaysKey(key),
    (cluster.figures[key] ?? Number.NaN) / (round[RELAYS]!.figures[key] ?? Number.NaN),
  ]);
  const figures = { ...cluster.figures, ...Object.fromEntries(ratios) };
  return { [CLUSTER_SUBJECT]: { ...cluster, figures } };
}

function fanOutAcross(): Workload {
  const goals = { [CLUSTER_SUBJECT]: 0.85 };
  return {
    name: 'cluster-fan-out',
    group: 'cluster',
    reference: NATS,
    placement: 'core-each',
    roundShare: 1,
    title: `Fan-out 1 -> ${SUBSCRIBERS} at three masters, ${SMALL_BYTES} B record, window ${WINDOW}`,
    figures: fanOutFigures(goals),
    open: async (setting) => {
      const cluster = await clusterOf(setting);
      const ring = createRecordRing('cluster-fan-out', SMALL_BYTES);
      const single = await aloneOf(setting);
      return [
        fanOut(NATS, cluster.pids, cluster.nats, ring),
        fanOut(CLUSTER_SUBJECT, cluster.pids, accessToAll(cluster), ring),
        fanOut(SINGLE, single.pids, single, ring),
      ];
    },
  };
}

function localRoundTrip(): Workload {
  const goals = { [TOGETHER]: 1.05 };
  return {
    name: 'cluster-local-round-trip',
    group: 'cluster',
    reference: ALONE,
    placement: 'one-core',
    roundShare: 1,
    title: `Round trip at one master of a cluster, ${SMALL_BYTES} B record, closed loop`,
    figures: roundTripFigures({ p50Us: goals, cpuUs: goals }),
    open: (setting) =>
      localSubjects(setting, (name, pids, access) => {
        const ring = createRecordRing('cluster-local', SMALL_BYTES);
        return subject(name, pids, [{ access, ring }]);
      }),
  };
}

function localFanOut(): Workload {
  return {
    name: 'cluster-local-fan-out',
    group: 'cluster',
    reference: ALONE,
    placement: 'core-each',
    roundShare: 1,
    title: `Fan-out 1 -> ${SUBSCRIBERS} at one master of a cluster, ${SMALL_BYTES} B record, window ${WINDOW}`,
    figures: fanOutFigures({ [TOGETHER]: 0.95 }),
    open: (setting) =>
      localSubjects(setting, (name, pids, access) => {
        const ring = createRecordRing('cluster-local', SMALL_BYTES);
        return fanOut(name, pids, access, ring);
      }),
  };
}

/** The same at a master without others, and at one of three that have nothing to do. */
async function localSubjects(
  setting: WorkloadSetting,
  create: (name: string, pids: readonly number[], access: Access) => Subject,
): Promise<Subject[]> {
  const cluster = await clusterOf(setting);
  const alone = await aloneOf(setting);
  const { pid } = cluster.masters[0]!;
  return [
    create(ALONE, alone.pids, alone),
    create(TOGETHER, cluster.pids, accessTo(cluster, 0, [pid])),
  ];
}

function clusterOf({ parts, master, profileDir }: WorkloadSetting): Promise<RunningCluster> {
  return parts.get('cluster', () => startCluster(master, profileDir));
}

function relaysOf({ parts, profileDir }: WorkloadSetting, nats: NatsPart): Promise<Relays> {
  return parts.get('relays', () => startRelays(nats, profileDir));
}

async function aloneOf({ parts, master, profileDir }: WorkloadSetting): Promise<Access> {
  const running = await parts.get('master-alone', () =>
    MasterProcess.start({ program: master, profileDir, profileName: 'ubii-alone' }),
  );
  return {
    pids: [running.pid],
    join: (role, receiver) => joinMaster(running, role, receiver, true),
  };
}

/** A leg for each ring, received in turn at these. */
function legsOf(rings: readonly RecordRing[], accesses: readonly (Access | NatsPart)[]): Leg[] {
  return rings.map((ring, index) => ({ access: accesses[index % accesses.length]!, ring }));
}

/** @param pids processes to be placed; those of the legs are measured */
function subject(name: string, pids: readonly number[], legs: readonly Leg[]): Subject {
  const measured = legs[0]!.access.pids;
  const measure = (options: MeasureOptions): Promise<Measurement> =>
    measureLegs(legs, measured, options);
  return warmed({ name, pids, measure }, CPU_KEY);
}

function fanOut(name: string, pids: readonly number[], access: Access, ring: RecordRing): Subject {
  const fan = { subscribers: SUBSCRIBERS, window: WINDOW };
  const measure = (options: MeasureOptions): Promise<Measurement> =>
    measureFanOut(fan, access, ring, options);
  return warmed({ name, pids, measure }, CPU_KEY);
}

function roundTripFigures(goals: Record<string, FigureInfo['goals']>): FigureInfo[] {
  const figure = (key: string, label: string, unit: string): FigureInfo => ({
    key,
    label,
    unit,
    isHigherBetter: false,
    goals: goals[key] ?? {},
  });
  return [
    figure('p50Us', 'p50', 'µs'),
    figure('p99Us', 'p99', 'µs'),
    figure('cpuUs', 'broker CPU a round trip', 'µs'),
    figure('loadCpu', 'load generator CPU', 'cores'),
  ];
}

function fanOutFigures(goals: FigureInfo['goals']): FigureInfo[] {
  return [
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
  ];
}
