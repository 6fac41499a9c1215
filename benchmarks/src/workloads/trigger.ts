import type { EmptyRecord, TopicRecord, Init, ProcessingModule } from '@ubii/proto';
import { MasterProcess } from '@ubii/harness';

import { joinMaster } from '../brokers/brokers.ts';
import type { BrokerClient, ClientRole } from '../brokers/target.ts';
import type { Callee } from '../calls/call-series.ts';
import { measureCalls, warmUp } from '../calls/measure-calls.ts';
import { bareCallee } from '../calls/module-callee.ts';
import { RECORD_PAYLOAD } from '../calls/payload.ts';
import type { StreamReceiver } from '../load/load-connection.ts';
import { RecordReceiver } from '../load/record-receiver.ts';
import { RING_RECORDS, createRecordRing, type RecordRing } from '../load/record-ring.ts';
import type { Measurement, Subject, Workload } from '../measuring/workload.ts';
import { startBareWorker } from '../modules/node-sandboxes.ts';
import { startSession, writeModuleFolder } from '../modules/running-session.ts';

type Echo = TopicRecord | EmptyRecord;

/**
 * One client that publishes the records of a ring one by one, and waits for each to come back on
 * `answerTopic`.
 */
async function openEcho(
  join: (role: ClientRole, receiver: StreamReceiver) => Promise<BrokerClient>,
  ring: RecordRing,
  answerTopic: string,
): Promise<Callee<Buffer, Echo[]>> {
  const receiver = new RecordReceiver();
  let settle: { resolve(records: Echo[]): void; reject(reason: Error): void } | undefined;
  let arrived: Echo[] = [];
  // The clock is read when the frame is there; it is read itself and checked after that.
  receiver.onFrame = () => {
    arrived = [];
    settle?.resolve(arrived);
    settle = undefined;
  };
  receiver.onRecord = (record) => arrived.push(record);
  receiver.onEnd = (reason) => settle?.reject(new Error(reason));
  const { connection } = await join({ publishes: true, topics: [answerTopic] }, receiver);
  return {
    sequence: 0,
    prepare: (sequence) => ring.published.slice(sequence, 1),
    call: (frame) =>
      new Promise((resolve, reject) => {
        settle = { resolve, reject };
        connection.send(frame);
      }),
    isRight: (records, sequence) =>
      records.length === 1 && isRecordOf(records[0]!, answerTopic, sequence),
    abandon: (reason) => settle?.reject(reason),
    takeFaults: () => receiver.faults.splice(0),
  };
}

/** See `createRecordRing`. */
function isRecordOf({ topic, value }: Echo, answerTopic: string, sequence: number): boolean {
  const number = sequence % RING_RECORDS;
  const { x, y, z } = value as { x: number; y: number; z: number };
  return topic === answerTopic && x === number && y === Math.sin(number) && z === Math.cos(number);
}

/** A module that puts out the vector that came in, as soon as it came. */
const ECHO_MODULE = {
  name: 'benchmark-echo',
  onProcessingStringified:
    '(deltaTime, inputs) => ({ outputs: { out: { vector3: inputs.in.vector3 } } })',
  inputs: [{ internalName: 'in', messageFormat: 'vector3' }],
  outputs: [{ internalName: 'out', messageFormat: 'vector3' }],
  processingMode: { triggerOnInput: { minDelayMs: 0, allInputsNeedUpdate: false } },
} satisfies Init<ProcessingModule>;

const RECORD_BYTES = 100;
const PLAIN = 'plain';
const BARE_WORKER = 'bare worker';
/** Upper limit of a module's latency: see the README. */
const REFERENCE = 'plain + 1.5 x worker';
const WORKER_SHARE = 1.5;

/**
 * Record in, module on the master, record out: beside a record that only passes the master, and a
 * message to a worker and back.
 */
export const trigger: Workload = {
  name: 'trigger',
  group: 'trigger',
  title: `Record in -> module triggered by it on the master -> record out, ${RECORD_BYTES} B, closed loop`,
  figures: [
    {
      key: 'p50Us',
      label: 'p50',
      unit: 'µs',
      isHigherBetter: false,
      goals: { trusted: 1, sandboxed: 1 },
    },
    { key: 'p99Us', label: 'p99', unit: 'µs', isHigherBetter: false, goals: {} },
    { key: 'cpuUs', label: 'master CPU a record', unit: 'µs', isHigherBetter: false, goals: {} },
  ],
  reference: REFERENCE,
  // Only one thread has work at a time, as in the round trip.
  placement: 'one-core',
  roundShare: 1 / 3,
  open: async ({ parts, master: file, profileDir }) => {
    const folder = await parts.get('modules', () => writeModuleFolder([ECHO_MODULE]));
    const master = await parts.get('master', () =>
      MasterProcess.start({ program: file, profileDir, flags: ['--modules', folder.path] }),
    );
    const bare = await parts.get(BARE_WORKER, startBareWorker);
    const bareCalls = bareCallee(bare, RECORD_PAYLOAD);
    await warmUp(bareCalls);
    return [
      await plain(master),
      {
        name: BARE_WORKER,
        pids: [],
        measure: (options) => measureCalls(bareCalls, options),
      },
      await triggered('trusted', master, { name: ECHO_MODULE.name }),
      // Another name: that of the folder's module would be known, and trusted.
      await triggered('sandboxed', master, { ...ECHO_MODULE, name: 'benchmark-echo-of-session' }),
    ];
  },
  derive: (round) => {
    const passing = round[PLAIN]!;
    const call = round[BARE_WORKER]!;
    const sum = (key: string): number => passing.figures[key]! + WORKER_SHARE * call.figures[key]!;
    const allowed: Measurement = {
      figures: {
        p50Us: sum('p50Us'),
        p99Us: sum('p99Us'),
        // A worker in this process: what it takes is this process' own.
        cpuUs: passing.figures['cpuUs']! + WORKER_SHARE * call.figures['ownCpuUs']!,
      },
      deliveries: 0,
      otherCpuShare: passing.otherCpuShare,
      faults: [],
    };
    return { [REFERENCE]: allowed };
  },
};

async function plain(master: MasterProcess): Promise<Subject> {
  const ring = createRecordRing(PLAIN, RECORD_BYTES);
  return echoSubject(PLAIN, master, ring, ring.topic);
}

async function triggered(
  name: string,
  master: MasterProcess,
  module: Init<ProcessingModule>,
): Promise<Subject> {
  const ring = createRecordRing(name, RECORD_BYTES);
  const answerTopic = `/benchmark/${name}/out`;
  // It stays for all rounds: without records it costs nothing.
  await startSession(master, {
    name: `trigger ${name}`,
    processingModules: [module],
    ioMappings: [
      {
        processingModuleName: module.name ?? '',
        inputMappings: [{ inputName: 'in', topic: ring.topic }],
        outputMappings: [{ outputName: 'out', topic: answerTopic }],
      },
    ],
  });
  return echoSubject(name, master, ring, answerTopic);
}

async function echoSubject(
  name: string,
  master: MasterProcess,
  ring: RecordRing,
  answerTopic: string,
): Promise<Subject> {
  const pids = [master.pid];
  const callee = await openEcho(
    (role, receiver) => joinMaster(master, role, receiver, true),
    ring,
    answerTopic,
  );
  await warmUp(callee);
  return { name, pids, measure: (options) => measureCalls(callee, options, pids) };
}
