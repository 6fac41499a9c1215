import { Worker } from 'node:worker_threads';
import { setTimeout as sleep } from 'node:timers/promises';

import { MasterProcess } from '@ubii/harness';
import { SERVICES } from '@ubii/proto';

import { joinMaster } from '../brokers/brokers.ts';
import type { Target } from '../brokers/target.ts';
import { DeliveryVerifier } from '../load/delivery-verifier.ts';
import { createRecordRing, type RecordRing } from '../load/record-ring.ts';
import { startLap } from '../measuring/stopwatch.ts';
import {
  describeFaults,
  type Measurement,
  type MeasureOptions,
  type Workload,
} from '../measuring/workload.ts';
import { percentile } from '../statistics.ts';

/** One request that is sent all the time. */
interface SentBody {
  /** Of the service, as JSON. */
  readonly url: string;
  readonly headers: Readonly<Record<string, string>>;
  readonly body: string;
}

interface BodySender {
  /** Ends it after the request under way. @returns how many were sent, and the last answer */
  stop(): Promise<{ readonly answers: number; readonly last: string }>;
}

/** Starts a thread that sends it, see body-sender.mjs. */
function startBodySender(sent: SentBody): BodySender {
  const worker = new Worker(new URL('../load/body-sender.mjs', import.meta.url), {
    workerData: sent,
    execArgv: [],
  });
  const result = new Promise<{ answers: number; last: string }>((resolve, reject) => {
    worker.once('message', resolve);
    worker.once('error', reject);
  });
  return {
    stop: () => {
      worker.postMessage('stop');
      return result;
    },
  };
}

const MIB = 1024 * 1024;
const RECORD_BYTES = 100;
/** Between the answer and the next record: often enough to meet each body, and not a load of its own. */
const PAUSE_MS = 1;
/** No answer for so long: the record is lost. */
const STALL_MS = 60_000;
/** Nobody's body holds records up for longer than this, milliseconds. */
const MAX_STALL_MS = 25;

const NO_BODIES = 'no bodies';

const save = (members: string): string =>
  `{"topic":"${SERVICES.sessionDatabaseSave.topic}","session":{${members}}}`;
const module = (code: string): string => `{"name":"m","onProcessingStringified":"${code}"}`;

/**
 * Hostile bodies that are sent meanwhile: the largest allowed of each kind, and one that was once enough to stop a
 * master.
 */
const BODIES: Readonly<
  Record<string, { readonly stranger?: boolean; readonly body: () => string }>
> = {
  'a session of 11 MiB, in escapes': {
    body: () =>
      save(
        `"processingModules":[${Array(4)
          .fill(module('\\u00e9'.repeat(480_000)))
          .join(',')}]`,
      ),
  },
  'a session of 60 000 values': {
    body: () =>
      save(`"processingModules":[${Array(20_000).fill('{"id":"","name":""}').join(',')}]`),
  },
  '31 MiB of lists in lists': { body: () => `{"u":${'['.repeat(31 * MIB)}` },
  '31 MiB of objects': { body: () => `{"u":[${'{"a":0},'.repeat((31 * MIB) / 8)}` },
  '31 MiB of objects, by a stranger': {
    stranger: true,
    body: () => `{"u":[${'{"a":0},'.repeat((31 * MIB) / 8)}`,
  },
};

/** One client publishes a record and waits for it, while another sends large requests to the same master. */
export const hostileBodies: Workload = {
  name: 'hostile-bodies',
  group: 'hostile-bodies',
  title: 'Round trip of a record while somebody sends large requests without pause',
  figures: [
    {
      key: 'longestMs',
      label: 'longest',
      unit: 'ms',
      isHigherBetter: false,
      goals: {},
      bounds: Object.fromEntries(Object.keys(BODIES).map((name) => [name, MAX_STALL_MS])),
    },
    { key: 'p99Ms', label: 'p99', unit: 'ms', isHigherBetter: false, goals: {} },
    { key: 'p50Ms', label: 'p50', unit: 'ms', isHigherBetter: false, goals: {} },
    { key: 'bodies', label: 'requests', unit: '/s', isHigherBetter: true, goals: {} },
  ],
  reference: NO_BODIES,
  placement: 'anywhere',
  roundShare: 1,
  open: async ({ parts, master, profileDir }) => {
    const ring = createRecordRing('hostile-bodies', RECORD_BYTES);
    const running = await parts.get('master', () =>
      MasterProcess.start({ program: master, profileDir }),
    );
    return [NO_BODIES, ...Object.keys(BODIES)].map((name) => ({
      name,
      pids: [running.pid],
      measure: (options) => measure(running, name, ring, options),
    }));
  },
};

async function measure(
  master: MasterProcess,
  name: string,
  ring: RecordRing,
  { warmUpMs, measureMs }: MeasureOptions,
): Promise<Measurement> {
  const hostile = BODIES[name];
  const verifier = new DeliveryVerifier(ring);
  const role: Parameters<Target['join']>[0] = { publishes: true, topics: [ring.topic] };
  const { connection, leave } = await joinMaster(master, role, verifier, true);
  const sender =
    hostile &&
    startBodySender({
      url: `${master.url}/services/json`,
      headers: {
        'content-type': 'application/json',
        ...(hostile.stranger && { 'x-forwarded-for': '203.0.113.7' }),
      },
      body: hostile.body(),
    });
  await sleep(warmUpMs);
  const samples: number[] = [];
  let sent = 0;
  const stopLap = startLap([master.pid]);
  const endMs = performance.now() + measureMs;
  while (performance.now() < endMs) {
    const back = new Promise<void>((resolve) => (verifier.onProgress = resolve));
    const startMs = performance.now();
    connection.send(ring.published.slice(sent, 1));
    sent += 1;
    await Promise.race([back, sleep(STALL_MS, undefined, { ref: false })]);
    samples.push(performance.now() - startMs);
    await sleep(PAUSE_MS);
  }
  const lap = stopLap();
  const result = await sender?.stop();
  verifier.finish(sent);
  await leave();
  const sorted = samples.sort((a, b) => a - b);
  const seconds = (warmUpMs + measureMs) / 1000;
  return {
    figures: {
      longestMs: sorted.at(-1) ?? Number.NaN,
      p99Ms: percentile(sorted, 0.99),
      p50Ms: percentile(sorted, 0.5),
      bodies: (result?.answers ?? 0) / seconds,
    },
    otherCpuShare: lap.otherCpuShare,
    deliveries: samples.length,
    faults: describeFaults([verifier.faults]),
  };
}
