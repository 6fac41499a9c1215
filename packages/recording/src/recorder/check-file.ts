import { RecordingState } from '@ubii/proto';
import { counted, plural } from '@ubii/words';
import { judgeRecording } from '../reading/judge-recording.ts';
import type { MalformedEvents } from '../reading/recorded-events.ts';
import { RecordingReader } from '../reading/recording-reader.ts';
import { RecordingError } from '../records/recording-error.ts';
import { changeRecording, repairRecording } from '../repair/repair-recording.ts';
import type { CheckJob, FileChecker, ListedFile, Verdict } from './file-checker.ts';
import { adoptedFacts, boundFacts, listedSelection } from './bound-facts.ts';
import { describeFile, formatHeader, parseFacts, type FileFacts } from './file-facts.ts';
import { msOf } from '../records/recorded-record.ts';
import type { RecordingJob } from './recorder.ts';
import type { RecorderLimits } from './recorder-limits.ts';
import type { OpenFile, RecordingFolder } from './recording-folder.ts';

/** What became of a recording. */
export type Outcome = Pick<FileFacts, 'state' | 'problem'>;

const NOT_REPAIRED: Outcome = {
  state: RecordingState.RECORDING_STATE_FAILED,
  problem:
    'The end of the file is missing, and it could not be repaired, as on a full disk. The next start tries again.',
};

/** Checks files on the thread that asks. */
export class LocalChecker implements FileChecker {
  readonly #folder: RecordingFolder;
  readonly #limits: RecorderLimits;

  constructor(folder: RecordingFolder, limits: RecorderLimits) {
    this.#folder = folder;
    this.#limits = limits;
  }

  async check({ id, upload }: CheckJob): Promise<Verdict> {
    const file = await (upload ? this.#folder.editUpload(id) : this.#folder.edit(id));
    try {
      if (upload !== undefined) await adopt(file, upload.job, upload.nowMs, this.#limits);
      // A full disk has no room for it: it can be read anyway.
      else await repair(file).catch(rethrowRefusal);
      return { kind: 'accepted', file: await readListed(id, file, this.#limits) };
    } catch (error) {
      const reason = refusalOf(error);
      if (reason === undefined) throw error;
      return { kind: 'refused', reason };
    } finally {
      await file.close();
    }
  }

  close(): Promise<void> {
    return Promise.resolve();
  }
}

/** Reads a file that is whole, or as far as it is. @param outcome what became of it, where the file itself cannot say it */
export async function readListed(
  id: string,
  file: OpenFile,
  limits: RecorderLimits,
  outcome?: Outcome,
): Promise<ListedFile> {
  const { summary, malformed } = await RecordingReader.open(file);
  const facts = {
    ...boundFacts(withProblem(parseFacts(summary), malformed), limits),
    ...(summary.isDamaged && NOT_REPAIRED),
    ...outcome,
  };
  const described = describeFile(id, facts, summary, Number(await file.size()));
  const recording = { ...described, selection: listedSelection(facts.selection) };
  return { facts: { makerId: facts.makerId }, recording };
}

/** [RC-7] */
async function repair(file: OpenFile): Promise<void> {
  const done = await repairRecording(file);
  if (done === undefined) return;
  const { summary } = await RecordingReader.open(file);
  const facts = {
    ...parseFacts(summary),
    state: RecordingState.RECORDING_STATE_REPAIRED,
    problem: problemOf(done.lostAfterNs),
  };
  await changeRecording(file, { header: formatHeader(facts) });
}

/** [RC-41] */
async function adopt(
  file: OpenFile,
  job: RecordingJob,
  nowMs: number,
  limits: RecorderLimits,
): Promise<void> {
  await repairRecording(file);
  await judgeRecording(file, limits);
  const { summary } = await RecordingReader.open(file);
  const facts = adoptedFacts(job, parseFacts(summary), nowMs, limits);
  await changeRecording(file, { header: formatHeader(facts) });
}

/** Says so when events are left out. [RC-55] */
function withProblem(facts: FileFacts, malformed: MalformedEvents | undefined): FileFacts {
  if (malformed === undefined) return facts;
  const { count, first } = malformed;
  const text = `${counted(count, 'malformed event')} ${plural(count, 'is', 'are')} left out. ${first}`;
  return { ...facts, problem: [facts.problem, text].filter((one) => one !== '').join(' ') };
}

function problemOf(lostAfterNs: bigint | undefined): string {
  const why = 'The program that wrote the file ended before it closed it.';
  if (lostAfterNs === undefined) return `${why} There is no record in it.`;
  const time = new Date(msOf(lostAfterNs)).toISOString();
  return `${why} Records after ${time} may be missing, at most a second.`;
}

function rethrowRefusal(error: unknown): void {
  if (refusalOf(error) !== undefined) throw error;
}

/** Why a file is no recording; undefined for errors of the disk, which have a code. */
function refusalOf(error: unknown): string | undefined {
  if (error instanceof RecordingError) return error.message;
  // Bytes that a parser does not expect.
  const isOfContent = error instanceof RangeError || error instanceof TypeError;
  return isOfContent && !('code' in error) ? 'Its content is damaged.' : undefined;
}
