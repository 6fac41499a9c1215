import { existsSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { MasterProcess } from '@ubii/harness';

import { pause } from '../pause.ts';
import { Random } from '../random.ts';
import { judgeGrowth, type Growth } from './growth.ts';
import { Gauge, probeFlags, QUANTITIES, type Quantity, type Sample } from './measure.ts';
import { inviteAnew, look, runSession } from './workload/operator.ts';
import { bePhone, type PhoneWorld } from './workload/phones.ts';
import { bringFile, makeUploadedFiles, record, type UploadedFiles } from './workload/recordings.ts';
import { Shift } from './workload/shift.ts';
import { Tally } from './workload/tally.ts';
import { Talker } from './workload/talkers.ts';

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
  onSample?(sample: Sample, tally: Tally): void;
}

export interface SoakResult {
  readonly growth: ReadonlyMap<Quantity, Growth>;
  /** At rest after the warm-up, and at rest at the end. */
  readonly quiet: readonly [Sample, Sample];
  readonly tally: Tally;
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
  const tally = new Tally();
  const talkers: Talker[] = [];
  for (let index = 0; index < plan.clients; index++) {
    talkers.push(await Talker.open(master, `talker ${index}`, tally));
  }
  const files = await makeUploadedFiles();
  const world: PhoneWorld = { master, tally, random: new Random(plan.seed), token: '' };
  const samples: Sample[] = [];
  const work = async (durationMs: number, into?: Sample[]): Promise<void> => {
    const shift = begin(plan, world, talkers, files);
    const endMs = performance.now() + durationMs;
    while (performance.now() < endMs) {
      await pause(plan.durationMs / SAMPLES);
      if (!master.isRunning)
        throw new Error(`The master has ended.\n${master.log.slice(-12).join('\n')}`);
      try {
        const sample = await gauge.read();
        plan.onSample?.(sample, tally);
        into?.push(sample);
      } catch {
        // On a machine that others keep busy, a sample may be late beyond patience; the next one counts again.
        if (master.isRunning) tally.done('samples left out');
      }
    }
    await shift.end();
  };
  await work(plan.durationMs * WARM_UP);
  const first = await rest(gauge, plan.clients);
  await work(plan.durationMs * (1 - WARM_UP), samples);
  const last = await rest(gauge, plan.clients);
  await Promise.all(talkers.map((talker) => talker.close()));
  const growth = new Map(
    (Object.keys(QUANTITIES) as Quantity[]).map((quantity) => [
      quantity,
      judgeGrowth(
        samples.map((sample) => sample[quantity]),
        QUANTITIES[quantity],
      ),
    ]),
  );
  return { growth, quiet: [first, last], tally, failures: master.failures };
}

function begin(
  plan: SoakPlan,
  world: PhoneWorld,
  talkers: readonly Talker[],
  files: UploadedFiles,
): Shift {
  const { master, random, tally } = world;
  const shift = new Shift();
  for (const talker of talkers) talker.work(shift);
  for (let index = 0; index < plan.sessions; index++) {
    shift.employ(
      () => runSession(master, `soak ${index}`, tally),
      (error) => tally.failed('session', error),
    );
  }
  for (let index = 0; index < plan.uploads; index++) {
    shift.employ(
      () => bringFile(master, files, random, tally),
      (error) => tally.failed('upload', error),
    );
  }
  shift.employ(
    () => record(master, tally),
    (error) => tally.failed('recording', error),
  );
  shift.employ(
    () => inviteAnew(world),
    (error) => tally.failed('invitation', error),
  );
  shift.employ(
    () => look(master, tally),
    (error) => tally.failed('look', error),
  );
  for (let index = 0; index < plan.phones; index++) {
    shift.employ(
      async () => {
        if (world.token === '') return pause(20);
        await bePhone(world);
      },
      // Its invitation was revoked meanwhile: that is part of the work.
      (error) =>
        /revoked|403|Unexpected server response/.test(String(error))
          ? tally.done('phones sent away')
          : tally.failed('phone', error),
    );
  }
  return shift;
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
