import { existsSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { MasterProcess } from '@ubii/harness';

import { pause } from '../pause.ts';
import { Random } from '../random.ts';
import {
  judgeGrowth,
  Gauge,
  probeFlags,
  QUANTITIES,
  type Growth,
  type Quantity,
  type Sample,
} from './measure.ts';
import { renewInvitation, listEverything, runSession } from './workload/operator.ts';
import { runPhone, type PhoneSetup } from './workload/phones.ts';
import {
  uploadAndDelete,
  makeUploadedFiles,
  record,
  type UploadedFiles,
} from './workload/recordings.ts';
import { WorkerLoops, EchoClient } from './workload/echo-clients.ts';
import { Counters } from './workload/counters.ts';

const MEMORY = '/dev/shm';
const SAMPLES = 120;
/** Share of the run after which everything that is kept has been filled once. */
const WARM_UP = 0.25;
/** Limits of data kept about former clients; lower than the defaults, so that the warm-up reaches them. */
const LIMITS = 'unavailableRetentionMs=5000,keptRemovals=200,auditEntries=500';
/** Time until those who went silently are forgotten: the silence of CL-11, and the retention above. */
const QUIET_MS = 90_000;

export interface SoakPlan {
  readonly program: string;
  readonly durationMs: number;
  readonly clients: number;
  readonly phones: number;
  readonly sessions: number;
  /** Files at once that are uploaded, played and deleted; hostile ones among them. */
  readonly uploads: number;
  readonly seed: number;
  onSample?(sample: Sample, counters: Counters): void;
}

export interface SoakResult {
  readonly growth: ReadonlyMap<Quantity, Growth>;
  /** At rest after the warm-up, and at rest at the end. */
  readonly quiet: readonly [Sample, Sample];
  readonly counters: Counters;
  /** Errors that the master logged. */
  readonly failures: readonly string[];
}

/** Keeps a master busy, and measures what it holds. @throws Error when it ends */
export async function soak(plan: SoakPlan): Promise<SoakResult> {
  // In memory where there is such a place: a slow disk would slow down everything, and is no part of this.
  const folder = mkdtempSync(join(existsSync(MEMORY) ? MEMORY : tmpdir(), 'ubii-soak-'));
  const probe = join(folder, 'probe.json');
  const master = await MasterProcess.start({
    program: plan.program,
    dataDir: join(folder, 'data'),
    flags: ['--limits', LIMITS],
    nodeFlags: probeFlags(probe),
  });
  try {
    return await soakMaster(plan, master, new Gauge(master, probe));
  } finally {
    await master.dispose();
    rmSync(folder, { recursive: true, force: true });
  }
}

async function soakMaster(
  plan: SoakPlan,
  master: MasterProcess,
  gauge: Gauge,
): Promise<SoakResult> {
  const counters = new Counters();
  const echoClients: EchoClient[] = [];
  for (let index = 0; index < plan.clients; index++) {
    echoClients.push(await EchoClient.open(master, `echo client ${index}`, counters));
  }
  const files = await makeUploadedFiles();
  const setup: PhoneSetup = { master, counters, random: new Random(plan.seed), token: '' };
  const samples: Sample[] = [];
  const work = async (durationMs: number, into?: Sample[]): Promise<void> => {
    const loops = begin(plan, setup, echoClients, files);
    const endMs = performance.now() + durationMs;
    while (performance.now() < endMs) {
      await pause(plan.durationMs / SAMPLES);
      if (!master.isRunning)
        throw new Error(`The master has ended.\n${master.log.slice(-12).join('\n')}`);
      try {
        const sample = await gauge.read();
        plan.onSample?.(sample, counters);
        into?.push(sample);
      } catch {
        // On a machine that others keep busy, a sample may pass its time limit; the next one counts again.
        if (master.isRunning) counters.done('samples left out');
      }
    }
    await loops.end();
  };
  await work(plan.durationMs * WARM_UP);
  const first = await rest(gauge, plan.clients);
  await work(plan.durationMs * (1 - WARM_UP), samples);
  const last = await rest(gauge, plan.clients);
  await Promise.all(echoClients.map((echoClient) => echoClient.close()));
  const growth = new Map(
    (Object.keys(QUANTITIES) as Quantity[]).map((quantity) => [
      quantity,
      judgeGrowth(
        samples.map((sample) => sample[quantity]),
        QUANTITIES[quantity],
      ),
    ]),
  );
  return { growth, quiet: [first, last], counters, failures: master.failures };
}

function begin(
  plan: SoakPlan,
  setup: PhoneSetup,
  echoClients: readonly EchoClient[],
  files: UploadedFiles,
): WorkerLoops {
  const { master, random, counters } = setup;
  const loops = new WorkerLoops();
  for (const echoClient of echoClients) echoClient.work(loops);
  for (let index = 0; index < plan.sessions; index++) {
    loops.add(
      () => runSession(master, `soak ${index}`, counters),
      (error) => counters.failed('session', error),
    );
  }
  for (let index = 0; index < plan.uploads; index++) {
    loops.add(
      () => uploadAndDelete(master, files, random, counters),
      (error) => counters.failed('upload', error),
    );
  }
  loops.add(
    () => record(master, counters),
    (error) => counters.failed('recording', error),
  );
  loops.add(
    () => renewInvitation(setup),
    (error) => counters.failed('invitation', error),
  );
  loops.add(
    () => listEverything(master, counters),
    (error) => counters.failed('look', error),
  );
  for (let index = 0; index < plan.phones; index++) {
    loops.add(
      async () => {
        if (setup.token === '') return pause(20);
        await runPhone(setup);
      },
      // Its invitation was revoked meanwhile: that is part of the work.
      (error) =>
        /revoked|403|Unexpected server response/.test(String(error))
          ? counters.done('phones sent away')
          : counters.failed('phone', error),
    );
  }
  return loops;
}

/** Waits until only those who stay are there, then measures. */
async function rest(gauge: Gauge, clients: number): Promise<Sample> {
  const endMs = performance.now() + QUIET_MS;
  let sample = await gauge.read();
  while (sample.clients > clients && performance.now() < endMs) {
    await pause(1_000);
    sample = await gauge.read();
  }
  await pause(2_000);
  return gauge.read();
}
