import { join } from 'node:path';

import { SmallDisk } from '../small-disk.ts';
import type { Outcome, Stage, Story } from '../story.ts';
import { Theatre } from '../theatre.ts';

const MEBIBYTES = 2;
/** The most that a description may have. */
const TEXT_LENGTH = 4_000;
const TRIES = 5;

/** Takes away what the master writes to, and gives it back. */
interface DiskFault {
  begin(disk: SmallDisk): Promise<void> | void;
  end(disk: SmallDisk): Promise<void> | void;
}

function diskStory(name: string, about: string, fault: DiskFault): Story {
  return {
    name,
    about,
    reasonAgainst: () => SmallDisk.reasonAgainst(),
    run: (stage) => tellDiskStory(stage, fault),
  };
}

async function tellDiskStory(
  { program, random, times }: Stage,
  fault: DiskFault,
): Promise<Outcome> {
  const disk = new SmallDisk(MEBIBYTES);
  const dataDir = join(disk.folder, 'data');
  const theatre = await Theatre.open({ program, dataDir }, random, { textLength: TEXT_LENGTH });
  const losses: string[] = [];
  const backMs: number[] = [];
  const notes: string[] = [];
  try {
    const pulse = await theatre.pulse();
    for (let index = 0; index < times; index++) {
      await theatre.workFor(500);
      await fault.begin(disk);
      let stored = 0;
      for (let tries = 0; tries < TRIES; tries++) if (await theatre.scribe.save()) stored++;
      if (stored > 0) notes.push(`${stored} of ${TRIES} sessions were stored anyway`);
      // Records go on: they need no disk.
      await pulse.beat();
      losses.push(...(await theatre.findLosses()));
      const begunMs = performance.now();
      await fault.end(disk);
      if (!(await theatre.scribe.save())) {
        losses.push(`nothing can be stored afterwards: ${theatre.scribe.lastRefusal}`);
      }
      backMs.push(performance.now() - begunMs);
      // A restart shows whether acknowledged changes are on the disk, not only in memory.
      await theatre.master.kill();
      await theatre.master.restart();
      await pulse.beat();
      losses.push(...(await theatre.findLosses()));
    }
    notes.push(await startWithout(theatre, disk, fault));
    losses.push(...(await theatre.findLosses()));
    return theatre.outcome(losses, backMs, notes);
  } finally {
    await theatre.close();
    disk.remove();
  }
}

/** Whether a master starts while the fault lasts; it starts afterwards in any case. */
async function startWithout(theatre: Theatre, disk: SmallDisk, fault: DiskFault): Promise<string> {
  await theatre.master.kill();
  await fault.begin(disk);
  try {
    await theatre.master.restart();
    await fault.end(disk);
    return 'a master starts meanwhile';
  } catch (error) {
    await fault.end(disk);
    await theatre.master.restart();
    const [, sentence = ''] = String((error as Error).message).split('\n');
    return `a master does not start meanwhile, and says: ${sentence.slice(0, 200)}`;
  }
}

export const fullDisk = diskStory('full-disk', `a disk of ${MEBIBYTES} MiB that is full`, {
  begin: (disk) => disk.fill(),
  end: (disk) => disk.empty(),
});

export const readOnlyDisk = diskStory('read-only-disk', 'a disk that can only be read', {
  begin: (disk) => disk.setReadOnly(true),
  end: (disk) => disk.setReadOnly(false),
});
