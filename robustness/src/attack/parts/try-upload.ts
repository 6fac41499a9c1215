import { existsSync, mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { type MasterProcess, mib, residentOfTree } from '@ubii/harness';
import { AccessRole } from '@ubii/proto';

import { startRecording, uploadRecording, type UploadAnswer } from '../../fixtures/recordings.ts';
import { pause } from '../../pause.ts';
import { comparison, finding, millis, type Finding } from '../attack.ts';
import type { AttackEnvironment } from '../environment/attack-environment.ts';

/** Others notice no longer stall. A busy machine adds its own delays. */
const MAX_STALL_MS = 250;
/** The master itself, and what judges files. */
const MAX_PEAK_BYTES = 1024 * 1024 * 1024;
const SAMPLE_MS = 50;

/** A file that a participant uploads while others record. */
export interface HostileFile {
  readonly name: string;
  make(): Promise<Uint8Array> | Uint8Array;
  /** Checks the replies about a file that was accepted. @returns more findings */
  look?(master: MasterProcess, id: string): Promise<readonly Finding[]>;
}

/** Uploads a file, uses it where it was accepted, and starts the master again with the same data. */
export async function tryUpload(
  environment: AttackEnvironment,
  hostile: HostileFile,
): Promise<readonly Finding[]> {
  const dataDir = mkdtempSync(join(tmpdir(), 'ubii-upload-'));
  environment.closeLater(() => rmSync(dataDir, { recursive: true, force: true }));
  const master = await environment.startMaster({ dataDir });
  const meter = await environment.gapMeter(master);
  const calmMs = await meter.during(async () => {});
  const running = await startRecording(master, 'of others');
  const file = await hostile.make();
  const { token } = await environment.invite(master, AccessRole.ACCESS_ROLE_PARTICIPANT);
  const caller = environment.outsider(master);
  const { bearer } = await caller.join(token);
  let answer: UploadAnswer | undefined;
  let looked: readonly Finding[] = [];
  let treeBytes = 0;
  const sampling = setInterval(() => {
    treeBytes = Math.max(treeBytes, residentOfTree(master.pid));
  }, SAMPLE_MS);
  const stallMs = await meter.during(async () => {
    answer = await uploadRecording(caller, file, { bearer });
    const id = answer.recording?.id;
    await whileRunning(master, () => master.call({ topic: '/services/ubii/recording_list' }));
    if (id === undefined) return;
    looked = (await whileRunning(master, async () => hostile.look?.(master, id))) ?? [];
    await whileRunning(master, () => play(master, id));
  });
  clearInterval(sampling);
  const peakBytes = Math.max(treeBytes, master.figures().peakBytes ?? 0);
  const lives = master.isRunning;
  const goesOn = lives && (await grows(master, running));
  if (lives) await master.stop();
  const next = await startAgain(environment, dataDir, running);
  const say = (what: string, isSo: boolean): Finding =>
    finding(`${hostile.name}: ${what}`, isSo ? 'yes' : 'no', 'yes', isSo);
  return [
    comparison(`${hostile.name}: ${mib(file.length)}, the answer`, describe(answer)),
    say('the master lives', lives),
    say('a running recording goes on', goesOn),
    say('the next start lists and records', next.works),
    finding(
      `${hostile.name}: files left when what is listed was deleted`,
      next.left.join(', ') || 'none',
      'none',
      next.left.length === 0,
    ),
    finding(
      `${hostile.name}: stall of records`,
      lives ? millis(stallMs) : 'for good',
      `at most ${MAX_STALL_MS} ms, or as before it (${millis(calmMs)})`,
      lives && stallMs <= Math.max(MAX_STALL_MS, 2 * calmMs),
    ),
    finding(
      `${hostile.name}: most resident, with its processes`,
      lives ? mib(peakBytes) : 'ended',
      `at most ${mib(MAX_PEAK_BYTES)}`,
      lives && peakBytes <= MAX_PEAK_BYTES,
    ),
    ...looked.map((one) => ({ ...one, what: `${hostile.name}: ${one.what}` })),
  ];
}

function describe(answer: UploadAnswer | undefined): string {
  if (answer === undefined || answer.status === 0) return 'none';
  if (answer.recording !== undefined) {
    const { problem } = answer.recording;
    return problem === '' ? 'accepted' : `accepted: ${problem.slice(0, 160)}`;
  }
  return `${answer.status} ${answer.refusal.slice(0, 240)}`;
}

/** An error is an answer; the end of the master is what the findings say. */
async function whileRunning<T>(
  master: MasterProcess,
  work: () => Promise<T>,
): Promise<T | undefined> {
  if (!master.isRunning) return undefined;
  return work().catch(() => undefined);
}

async function play(master: MasterProcess, recordingId: string): Promise<void> {
  const { replay } = await master.call({
    topic: '/services/ubii/replay_start',
    replayStartRequest: { recordingId, isLooping: true },
  });
  await pause(500);
  await master.call({
    topic: '/services/ubii/replay_stop',
    replayRequest: { id: replay!.id },
  });
}

/** Whether a recording still records what the meter publishes. */
async function grows(master: MasterProcess, id: string): Promise<boolean> {
  const count = async (): Promise<number> => {
    const { recording } = await master.call({
      topic: '/services/ubii/recording_get',
      recordingRequest: { id },
    });
    return recording!.recordCount;
  };
  try {
    const before = await count();
    await pause(1_500);
    return (await count()) > before;
  } catch {
    return false;
  }
}

/** Starts a master with what is in a folder, lists and records, and deletes everything that is listed. */
async function startAgain(
  environment: AttackEnvironment,
  dataDir: string,
  known: string,
): Promise<{ readonly works: boolean; readonly left: readonly string[] }> {
  const folder = join(dataDir, 'recordings');
  const left = (): string[] => (existsSync(folder) ? readdirSync(folder) : []);
  try {
    const master = await environment.startMaster({ dataDir });
    const { recordingList } = await master.call({ topic: '/services/ubii/recording_list' });
    const hasKnown = recordingList!.elements.some(({ id }) => id === known);
    const again = await startRecording(master, 'after it');
    await pause(500);
    const works = hasKnown && master.isRunning;
    await master.call({ topic: '/services/ubii/recording_stop', recordingRequest: { id: again } });
    const ids = [...recordingList!.elements.map(({ id }) => id), again];
    for (const id of ids) {
      await master.call({ topic: '/services/ubii/recording_delete', recordingRequest: { id } });
    }
    return { works, left: left() };
  } catch {
    return { works: false, left: left().filter((name) => !name.startsWith(known)) };
  }
}
