import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

import { pause } from '../../pause.ts';
import { FaultRun, type Outcome, type ScenarioOptions, type Scenario } from '../fault-run.ts';

/** A disk of its own, in memory. */
export class SmallDisk {
  readonly folder: string;
  readonly #removeWithUs = (): void => this.remove();

  /** Why there can be none here; undefined: there can. */
  static reasonAgainst(): string | undefined {
    if (process.platform !== 'linux') return 'file systems in memory are of Linux';
    if (process.getuid?.() !== 0) return 'mounting takes root';
    try {
      new SmallDisk(1).remove();
      return undefined;
    } catch (error) {
      return `"mount -t tmpfs" failed: ${String((error as Error).message).split('\n')[0]}`;
    }
  }

  /** @throws Error when it cannot be mounted */
  constructor(mebibytes: number) {
    this.folder = mkdtempSync(join(tmpdir(), 'ubii-disk-'));
    mount('-t', 'tmpfs', '-o', `size=${mebibytes}m`, 'ubii-faults', this.folder);
    process.once('exit', this.#removeWithUs);
  }

  /** Takes what is left of it, but for what a page of memory holds. */
  fill(): void {
    const file = join(this.folder, 'filler');
    let text = '';
    for (let size = 1 << 20; size >= 4_096; size /= 2) {
      try {
        for (;;) {
          writeFileSync(file, text + 'f'.repeat(size));
          text += 'f'.repeat(size);
        }
      } catch {
        // As much as this does not fit any more.
        writeFileSync(file, text);
      }
    }
  }

  /** Gives back what `fill` took. */
  empty(): void {
    rmSync(join(this.folder, 'filler'), { force: true });
  }

  /** Waits for what is being written: the system takes nothing away meanwhile. @throws Error after 5 s */
  async setReadOnly(isReadOnly: boolean): Promise<void> {
    const endMs = performance.now() + 5_000;
    for (;;) {
      try {
        mount('-o', `remount,${isReadOnly ? 'ro' : 'rw'}`, this.folder);
        return;
      } catch (error) {
        if (performance.now() > endMs) throw error;
        await pause(20);
      }
    }
  }

  remove(): void {
    process.off('exit', this.#removeWithUs);
    execFileSync('umount', ['-l', this.folder], { stdio: 'pipe' });
    rmSync(this.folder, { recursive: true, force: true });
  }
}

function mount(...args: readonly string[]): void {
  execFileSync('mount', args, { stdio: 'pipe' });
}

const MEBIBYTES = 2;
/** The most that a description may have. */
const TEXT_LENGTH = 4_000;
const TRIES = 5;

/** Makes the disk of the master unusable, and repairs it. */
interface DiskFault {
  begin(disk: SmallDisk): Promise<void> | void;
  end(disk: SmallDisk): Promise<void> | void;
}

function diskScenario(name: string, about: string, fault: DiskFault): Scenario {
  return {
    name,
    about,
    reasonAgainst: () => SmallDisk.reasonAgainst(),
    run: (options) => runDiskScenario(options, fault),
  };
}

async function runDiskScenario(
  { program, random, times }: ScenarioOptions,
  fault: DiskFault,
): Promise<Outcome> {
  const disk = new SmallDisk(MEBIBYTES);
  const dataDir = join(disk.folder, 'data');
  const faultRun = await FaultRun.open({ program, dataDir }, random, { textLength: TEXT_LENGTH });
  const losses: string[] = [];
  const backMs: number[] = [];
  const notes: string[] = [];
  try {
    const heartbeat = await faultRun.heartbeat();
    for (let index = 0; index < times; index++) {
      await faultRun.workFor(500);
      await fault.begin(disk);
      let stored = 0;
      for (let tries = 0; tries < TRIES; tries++) if (await faultRun.workload.save()) stored++;
      if (stored > 0) notes.push(`${stored} of ${TRIES} sessions were stored anyway`);
      // Records go on: they need no disk.
      await heartbeat.beat();
      losses.push(...(await faultRun.findLosses()));
      const begunMs = performance.now();
      await fault.end(disk);
      if (!(await faultRun.workload.save())) {
        losses.push(`nothing can be stored afterwards: ${faultRun.workload.lastRefusal}`);
      }
      backMs.push(performance.now() - begunMs);
      // A restart shows whether acknowledged changes are on the disk, not only in memory.
      await faultRun.master.kill();
      await faultRun.master.restart();
      await heartbeat.beat();
      losses.push(...(await faultRun.findLosses()));
    }
    notes.push(await startWithout(faultRun, disk, fault));
    losses.push(...(await faultRun.findLosses()));
    return faultRun.outcome(losses, backMs, notes);
  } finally {
    await faultRun.close();
    disk.remove();
  }
}

/** Whether a master starts while the fault lasts; it starts afterwards in any case. */
async function startWithout(
  faultRun: FaultRun,
  disk: SmallDisk,
  fault: DiskFault,
): Promise<string> {
  await faultRun.master.kill();
  await fault.begin(disk);
  try {
    await faultRun.master.restart();
    await fault.end(disk);
    return 'a master starts meanwhile';
  } catch (error) {
    await fault.end(disk);
    await faultRun.master.restart();
    const [, sentence = ''] = String((error as Error).message).split('\n');
    return `a master does not start meanwhile, and says: ${sentence.slice(0, 200)}`;
  }
}

export const fullDisk = diskScenario('full-disk', `a disk of ${MEBIBYTES} MiB that is full`, {
  begin: (disk) => disk.fill(),
  end: (disk) => disk.empty(),
});

export const readOnlyDisk = diskScenario('read-only-disk', 'a disk that can only be read', {
  begin: (disk) => disk.setReadOnly(true),
  end: (disk) => disk.setReadOnly(false),
});
