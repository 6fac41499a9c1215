import { RecordingKind, RecordingState, ServiceError, type Recording } from '@ubii/proto';
import { counted, plural } from '@ubii/words';
import { changeRecording } from '../repair/change-recording.ts';
import { RecordingError } from '../records/recording-error.ts';
import { judgeRecording } from '../reading/judge-recording.ts';
import type { MalformedEvents } from '../reading/recorded-events.ts';
import { RecordingReader } from '../reading/recording-reader.ts';
import { repairRecording } from '../repair/repair-recording.ts';
import type { KeptRecording, MarkerJob, RecordingJob, RecordingTexts } from './recorder.ts';
import { adoptedFacts } from './adopted-facts.ts';
import { boundFacts, listedSelection } from './bound-facts.ts';
import { describeFile, describeTopic, formatHeader, parseFacts } from './file-facts.ts';
import type { FileFacts } from './file-facts.ts';
import { describeMarker, MarkerList } from './marker-list.ts';
import { msOf } from './nanoseconds.ts';
import type { RecorderLimits } from './recorder-limits.ts';
import type { OpenFile, RecordingFolder } from './recording-folder.ts';
import { pageOf, type RecordingPage } from './recording-page.ts';

interface ListedFile {
  readonly facts: Pick<FileFacts, 'makerId'>;
  readonly recording: Recording;
}

/** What became of a recording. */
type Outcome = Pick<FileFacts, 'state' | 'problem'>;

const NOT_REPAIRED: Outcome = {
  state: RecordingState.RECORDING_STATE_FAILED,
  problem:
    'The end of the file is missing, and it could not be repaired, as on a full disk. The next start tries again.',
};

/** What the list works with. */
export interface FileListContext {
  readonly folder: RecordingFolder;
  readonly limits: RecorderLimits;
  /** The list changed. */
  onChange(): void;
}

/** Finished recordings: files of the folder, which are read once. */
export class FileList {
  readonly #context: FileListContext;
  readonly #files = new Map<string, ListedFile>();
  /** Files that are being written. */
  readonly #busy = new Set<string>();
  #scanned: Promise<void> | undefined = undefined;
  #queue: Promise<unknown> = Promise.resolve();

  constructor(context: FileListContext) {
    this.#context = context;
  }

  /** Reads and repairs what earlier runs left, once. [RC-7] */
  scan(): Promise<void> {
    this.#scanned ??= this.#scan();
    return this.#scanned;
  }

  /** Creates a file, which is not in the list until it is released and read. */
  create(id: string): Promise<OpenFile> {
    this.#busy.add(id);
    return this.#context.folder.create(id);
  }

  release(id: string): void {
    this.#busy.delete(id);
  }

  /** The newest first. */
  values(): Recording[] {
    return [...this.#files.values()]
      .map(({ recording }) => recording)
      .reverse()
      .sort((a, b) => b.startedMs - a.startedMs);
  }

  /** By id of the recording. */
  makers(): [id: string, makerId: string][] {
    return [...this.#files].map(([id, { facts }]) => [id, facts.makerId]);
  }

  /** @throws ServiceError when there is no recording of this id */
  async makerOf(id: string): Promise<string> {
    await this.scan();
    return this.#require(id).facts.makerId;
  }

  get sizeBytes(): number {
    return this.values().reduce((sum, { sizeBytes }) => sum + sizeBytes, 0);
  }

  /** @param page of topics and markers; default: none of them @throws ServiceError when there is none of this id */
  async get(id: string, page?: RecordingPage): Promise<KeptRecording> {
    await this.scan();
    return this.#ofListed(id, async ({ facts: { makerId }, recording }) => {
      const file = await this.#context.folder.open(id);
      try {
        if (page === undefined) return { recording, makerId };
        return { recording: { ...recording, ...(await this.#pageOf(id, file, page)) }, makerId };
      } finally {
        await file.close();
      }
    });
  }

  /** [RC-6] */
  async change(id: string, { name, notes }: RecordingTexts): Promise<Recording> {
    await this.scan();
    return this.#ofListed(id, async () => {
      await this.#edit(id, async (file) => {
        const { summary } = await RecordingReader.open(file);
        const facts = { ...boundFacts(parseFacts(summary), this.#context.limits), name, notes };
        await changeRecording(file, { header: formatHeader(facts) });
      });
      return this.read(id);
    });
  }

  /** [RC-22] */
  async mark(job: MarkerJob): Promise<void> {
    const { recordingId } = job.marker;
    await this.scan();
    await this.#ofListed(recordingId, async () => {
      await this.#edit(recordingId, async (file) => {
        const { summary } = await RecordingReader.open(file);
        const list = new MarkerList(summary.markers, this.#context.limits.markersPerRecording);
        await changeRecording(file, { events: [list.apply(job)] });
      });
      await this.read(recordingId);
    });
  }

  async delete(id: string): Promise<void> {
    await this.scan();
    this.#require(id);
    await this.#context.folder.delete(id);
    this.#forget(id);
  }

  /** Takes in a file that was uploaded. [RC-41] */
  async adopt(job: RecordingJob, nowMs: number): Promise<Recording> {
    const { folder, limits } = this.#context;
    await this.scan();
    await folder.takeUpload(job.id);
    try {
      await this.#edit(job.id, async (file) => {
        await repairRecording(file);
        await judgeRecording(file, limits);
        const { summary } = await RecordingReader.open(file);
        const facts = adoptedFacts(job, parseFacts(summary), nowMs, limits);
        await changeRecording(file, { header: formatHeader(facts) });
      });
      return await this.read(job.id);
    } catch (cause) {
      await folder.delete(job.id);
      if (!(cause instanceof RecordingError)) throw cause;
      const text = `The file is no recording: ${cause.message} Upload an MCAP file.`;
      throw new ServiceError('invalid_argument', text);
    }
  }

  /** Reads a file whose writing is finished. @param outcome what became of it, where the file itself cannot say it */
  async read(id: string, outcome?: Outcome): Promise<Recording> {
    const file = await this.#context.folder.open(id);
    try {
      const { summary, malformed } = await RecordingReader.open(file);
      const facts = {
        ...boundFacts(withProblem(parseFacts(summary), malformed), this.#context.limits),
        ...(summary.isDamaged && NOT_REPAIRED),
        ...outcome,
      };
      const described = describeFile(id, facts, summary, Number(await file.size()));
      const recording = { ...described, selection: listedSelection(facts.selection) };
      this.#files.set(id, { facts: { makerId: facts.makerId }, recording });
      this.#context.onChange();
      return recording;
    } finally {
      await file.close();
    }
  }

  /** Deletes the oldest keepings of the flight recorder as long as there is too much. [RC-18] */
  async makeRoom(maxBytes: number, runningBytes: number): Promise<void> {
    await this.scan();
    const keepings = this.values().filter(
      ({ kind }) => kind === RecordingKind.RECORDING_KIND_FLIGHT_RECORDER,
    );
    // The newest one stays: it was kept just now.
    for (const { id } of keepings.slice(1).reverse()) {
      if (this.sizeBytes + runningBytes <= maxBytes) return;
      await this.delete(id);
    }
  }

  #require(id: string): ListedFile {
    const listed = this.#files.get(id);
    if (listed !== undefined) return listed;
    throw new ServiceError('not_found', `No recording has the id "${id}".`);
  }

  #forget(id: string): void {
    this.#files.delete(id);
    this.#context.onChange();
  }

  /** Works with a file of the list. @throws ServiceError when it is gone, was deleted meanwhile, or cannot be read */
  async #ofListed<T>(id: string, work: (listed: ListedFile) => Promise<T>): Promise<T> {
    const listed = this.#require(id);
    try {
      return await work(listed);
    } catch (cause) {
      if (cause instanceof ServiceError) throw cause;
      // Another program deleted its file.
      if (this.#files.has(id) && !(await this.#context.folder.has(id))) this.#forget(id);
      this.#require(id);
      if (!(cause instanceof RecordingError)) throw cause;
      const text = `The file of this recording cannot be read: ${cause.message}`;
      throw new ServiceError('failed_precondition', text, { cause });
    }
  }

  async #pageOf(id: string, file: OpenFile, page: RecordingPage) {
    const { limits } = this.#context;
    const { summary } = await RecordingReader.open(file);
    const { selection } = boundFacts(parseFacts(summary), limits);
    return { selection, ...pageOf(id, summary, page, limits) };
  }

  async #scan(): Promise<void> {
    for (const id of await this.#context.folder.list()) {
      if (this.#busy.has(id) || this.#files.has(id)) continue;
      try {
        // A full disk has no room for it: it can be read anyway.
        await this.#repair(id).catch(() => undefined);
        await this.read(id);
      } catch {
        // No recording, or not readable: it is left alone. [RC-7]
      }
    }
  }

  /** [RC-7] */
  async #repair(id: string): Promise<void> {
    await this.#edit(id, async (file) => {
      const repair = await repairRecording(file);
      if (repair === undefined) return;
      const { summary } = await RecordingReader.open(file);
      const problem = problemOf(repair.lostAfterNs);
      const facts = {
        ...parseFacts(summary),
        state: RecordingState.RECORDING_STATE_REPAIRED,
        problem,
      };
      await changeRecording(file, { header: formatHeader(facts) });
    });
  }

  /** Changes a file of the list, one after the other. */
  #edit(id: string, change: (file: OpenFile) => Promise<void>): Promise<void> {
    const done = this.#queue.then(async () => {
      const file = await this.#context.folder.edit(id);
      try {
        await change(file);
      } finally {
        await file.close();
      }
    });
    this.#queue = done.catch(() => undefined);
    return done;
  }
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
