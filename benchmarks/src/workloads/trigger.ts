import { MasterProcess } from '@ubii/harness';
import type { Init, ProcessingModule } from '@ubii/proto';
import { joinMaster } from '../brokers/ubii.ts';
import { openEcho } from '../calls/echo-callee.ts';
import { measureCalls, warmUp } from '../calls/measure-calls.ts';
import { bareCallee } from '../calls/module-callee.ts';
import { RECORD_PAYLOAD } from '../calls/payload.ts';
import { createRecordRing, type RecordRing } from '../load/record-ring.ts';
import { startBareWorker } from '../modules/bare-worker.ts';
import { ECHO_MODULE } from '../modules/echo-module.ts';
import { startSession } from '../modules/running-session.ts';
import { writeModuleFolder } from '../modules/trusted-modules.ts';
import type { Measurement, Subject, Workload } from '../measuring/workload.ts';

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
