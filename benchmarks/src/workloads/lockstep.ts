import { setTimeout as sleep } from 'node:timers/promises';
import { MasterProcess } from '@ubii/harness';
import { sessionStatisticsTopic, type SessionStatistics } from '@ubii/proto';
import { counted } from '@ubii/words';
import { echoTopics, LOCKSTEP_MODULE, passTopics } from '../modules/lockstep-module.ts';
import { startLockstepNode, type LockstepNode } from '../modules/lockstep-node.ts';
import { buildWorkerFile } from '../modules/node-sandboxes.ts';
import {
  PassWatch,
  joinAsClient,
  numberFrame,
  vectorFrame,
  type LockstepClient,
} from './lockstep-client.ts';
import { startSession } from '../modules/running-session.ts';
import { median, percentile } from '../statistics.ts';
import { startLap } from '../measuring/stopwatch.ts';
import type {
  Measurement,
  MeasureOptions,
  Workload,
  WorkloadSetting,
} from '../measuring/workload.ts';

const GROUP = 'lockstep';
const CYCLE = 'cycle';
const REFERENCE = 'slowest node';
/** More than can be: a pass begins when the one before is over. */
const PASSES_PER_SECOND = 1000;
const INPUT_TOPIC = '/benchmark/lockstep/in';
/** Value on the input topic of the modules. */
const INPUT = 4711;
/** Share of the time for each closed loop that finds out what a message takes. */
const LOOP_SHARE = 1 / 4;
const UNKNOWN = Number.NaN;

/** Passes over the modules of some nodes, beside the round trip of the slowest node. */
export function lockstep(modules: number, nodes: number): Workload {
  return {
    name: `lockstep-${modules}-on-${nodes}`,
    group: GROUP,
    title: `Lockstep pass, ${counted(modules, 'module')} on ${counted(nodes, 'node')} (processes)`,
    figures: [
      {
        key: 'p50Us',
        label: 'pass, p50',
        unit: 'µs',
        isHigherBetter: false,
        goals: { [CYCLE]: 1.5 },
      },
      { key: 'p95Us', label: 'pass, p95', unit: 'µs', isHigherBetter: false, goals: {} },
      { key: 'perSecond', label: 'passes', unit: '1/s', isHigherBetter: true, goals: {} },
      {
        key: 'late',
        label: 'late answers',
        unit: '',
        isHigherBetter: false,
        goals: {},
        bounds: { [CYCLE]: 0 },
      },
    ],
    reference: REFERENCE,
    placement: 'anywhere',
    roundShare: 1 / 5,
    open: async (setting) => {
      const master = await setting.parts.get('master', () =>
        MasterProcess.start({ program: setting.master, profileDir: setting.profileDir }),
      );
      const running = await startNodes(nodes, master, setting);
      const pids = [master.pid, ...running.map(({ pid }) => pid)];
      return [
        {
          name: CYCLE,
          pids,
          measure: (options) => measurePasses(modules, master, running, pids, options),
        },
      ];
    },
    derive: (round) => {
      const { figures, otherCpuShare } = round[CYCLE]!;
      return {
        [REFERENCE]: {
          figures: { p50Us: figures['nodeP50Us']!, p95Us: figures['nodeP95Us']! },
          deliveries: 0,
          otherCpuShare,
          faults: [],
        },
      };
    },
  };
}

/** One node and three, with few modules and many. */
export const LOCKSTEPS: readonly Workload[] = [
  lockstep(1, 1),
  lockstep(8, 1),
  lockstep(32, 1),
  lockstep(8, 3),
  lockstep(32, 3),
];

async function startNodes(
  count: number,
  master: MasterProcess,
  { parts, profileDir }: WorkloadSetting,
): Promise<LockstepNode[]> {
  const worker = await parts.get('worker file', buildWorkerFile);
  const nodes: LockstepNode[] = [];
  while (nodes.length < count) {
    const name = `node-${nodes.length + 1}`;
    nodes.push(
      await parts.get(name, () => startLockstepNode(name, master, worker.path, profileDir)),
    );
  }
  return nodes;
}

async function measurePasses(
  modules: number,
  master: MasterProcess,
  nodes: readonly LockstepNode[],
  pids: readonly number[],
  { warmUpMs, measureMs }: MeasureOptions,
): Promise<Measurement> {
  const outputs = Array.from({ length: modules }, (_, place) => `/benchmark/lockstep/out/${place}`);
  const statistics: SessionStatistics[] = [];
  const watch = new PassWatch(outputs, INPUT);
  const faults: string[] = [];
  const probe = await joinAsClient(master, [
    INPUT_TOPIC,
    ...nodes.flatMap(({ name }) => [echoTopics(name).pong, passTopics(name).passes]),
  ]);
  await probe.ask(numberFrame(INPUT_TOPIC, INPUT), INPUT_TOPIC);
  const wayUs = await messageTimes(probe, nodes, measureMs * LOOP_SHARE);

  const session = await startSession(master, {
    name: `lockstep ${modules} on ${nodes.length}`,
    processingModules: outputs.map((_topic, place) => ({
      name: LOCKSTEP_MODULE.name,
      processingMode: LOCKSTEP_MODULE.processingMode,
      nodeId: nodes[place % nodes.length]!.id,
    })),
    ioMappings: outputs.map((topic) => ({
      processingModuleName: LOCKSTEP_MODULE.name,
      inputMappings: [{ inputName: 'in', topic: INPUT_TOPIC }],
      outputMappings: [{ outputName: 'out', topic }],
    })),
    extension: { lockstepHertz: PASSES_PER_SECOND },
  });
  const listener = await joinAsClient(master, [...outputs, sessionStatisticsTopic(session.id)]);
  // Joined in the middle of things: what was there before came first, and begins anywhere in a pass.
  await sleep(warmUpMs);
  let isCounting = false;
  listener.onRecord = (record) => {
    if (record.format === 'sessionStatistics') statistics.push(record.value);
    else if (isCounting) watch.handleRecord(record);
    else if (record.topic === outputs.at(-1)) isCounting = true;
  };
  for (const { name } of nodes) await askPasses(probe, name);
  statistics.length = 0;
  const passesBefore = watch.passes;
  const stopLap = startLap(pids);
  await sleep(2 * measureMs);
  const lap = stopLap();
  const passes = watch.passes - passesBefore;
  const shares: { p50Us: number; p95Us: number }[] = [];
  for (const { name } of nodes) shares.push(await askPasses(probe, name));
  listener.onRecord = () => {};
  await listener.leave();
  await session.stop();
  await probe.leave();

  if (statistics.length === 0) faults.push('the session told no statistics');
  if (passes === 0) faults.push('there were no passes');
  const nodeUs = (key: 'p50Us' | 'p95Us'): number =>
    Math.max(...shares.map((share, index) => share[key] + wayUs[index]!));
  return {
    figures: {
      p50Us: 1000 * median(statistics.map(({ passP50Ms }) => passP50Ms)),
      p95Us: 1000 * median(statistics.map(({ passP95Ms }) => passP95Ms)),
      perSecond: passes / (lap.wallUs / 1e6),
      late: statistics.at(-1)?.lateAnswers ?? UNKNOWN,
      nodeP50Us: nodeUs('p50Us'),
      nodeP95Us: nodeUs('p95Us'),
    },
    otherCpuShare: lap.otherCpuShare,
    deliveries: passes * modules,
    faults: [...faults, ...watch.faults, ...probe.receiver.faults, ...listener.receiver.faults],
  };
}

/**
 * Round-trip time of a message from the master to each node, µs: a record that the node answers, minus the time of a
 * record that only passes the master. Medians of closed loops.
 */
async function messageTimes(
  probe: LockstepClient,
  nodes: readonly LockstepNode[],
  forMs: number,
): Promise<number[]> {
  const plainUs = await loopUs(probe, numberFrame(INPUT_TOPIC, INPUT), INPUT_TOPIC, forMs);
  const times: number[] = [];
  for (const { name } of nodes) {
    const { ping, pong } = echoTopics(name);
    times.push(Math.max(0, (await loopUs(probe, vectorFrame(ping, 1), pong, forMs)) - plainUs));
  }
  return times;
}

async function loopUs(
  probe: LockstepClient,
  frame: Buffer,
  topic: string,
  forMs: number,
): Promise<number> {
  const samples: number[] = [];
  const untilMs = performance.now() + forMs;
  while (performance.now() < untilMs) {
    const startMs = performance.now();
    await probe.ask(frame, topic);
    samples.push((performance.now() - startMs) * 1000);
  }
  return percentile(
    samples.sort((a, b) => a - b),
    0.5,
  );
}

/** Median and 95th percentile of the durations of a node's shares since the request before, µs. */
async function askPasses(
  probe: LockstepClient,
  name: string,
): Promise<{ p50Us: number; p95Us: number }> {
  const { ask, passes } = passTopics(name);
  const { value } = await probe.ask(vectorFrame(ask, 1), passes);
  const { x, y } = value as { x: number; y: number };
  return { p50Us: 1000 * x, p95Us: 1000 * y };
}
