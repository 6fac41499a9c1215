import { RecordingKind, RecordingState, ServiceError, type Recording } from '@ubii/proto';
import { changeRecording } from '../repair/repair-recording.ts';
import { RecordingError } from '../records/recording-error.ts';
import { RecordingReader } from '../reading/recording-reader.ts';
import { boundFacts } from './bound-facts.ts';
import { readListed, type Outcome } from './check-file.ts';
import type { FileChecker, ListedFile, Verdict } from './file-checker.ts';
import type {
  KeptRecording,
  MarkerJob,
  RecordingJob,
  RecordingTexts,
  RecordingPage,
} from './recorder.ts';
import { formatHeader, parseFacts } from './file-facts.ts';
import { MarkerList } from './marker-list.ts';
import type { RecorderLimits } from './recorder-limits.ts';
import { listRejected, type OpenFile, type RecordingFolder } from './recording-folder.ts';
import { pageOf } from './recording-page.ts';

/** What the list works with. */
export interface FileListContext {
  readonly folder: RecordingFolder;
  readonly limits: RecorderLimits;
  /** Checks files that this list did not write. [RC-44] */
  readonly checker: FileChecker;
  readonly nowMs: () => number;
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

  /** Checks what earlier runs left, and repairs it, once. [RC-7] */
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

  /** @param page of topics and markers; default: neither @throws ServiceError when there is none of this id */
  async get(id: string, page?: RecordingPage): Promise<KeptRecording> {
    await this.scan();
    return this.#ofListed(id, async ({ facts: { makerId }, recording }) => {
      if (isRejected(recording)) return { recording, makerId };
      return this.#withFile(id, 'open', async (file) => {
        if (page === undefined) return { recording, makerId };
        return { recording: { ...recording, ...(await this.#pageOf(id, file, page)) }, makerId };
      });
    });
  }

  /** [RC-6] */
  async change(id: string, { name, notes }: RecordingTexts): Promise<Recording> {
    await this.scan();
    return this.#ofListed(id, async ({ recording }) => {
      requireReadable(recording);
      await this.#withFile(id, 'edit', async (file) => {
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
    await this.#ofListed(recordingId, async ({ recording }) => {
      requireReadable(recording);
      await this.#withFile(recordingId, 'edit', async (file) => {
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

  /** Takes in a file that was uploaded. It is an upload until it was checked. [RC-41] [RC-44] */
  async adopt(job: RecordingJob, nowMs: number): Promise<Recording> {
    const { folder, checker } = this.#context;
    await this.scan();
    try {
      const verdict = await checker.check({ id: job.id, upload: { job, nowMs } });
      if (verdict.kind !== 'accepted') throw await this.#refuse(job, verdict);
      await folder.takeUpload(job.id);
      return this.#add(job.id, verdict.file);
    } catch (cause) {
      await folder.dropUpload(job.id);
      throw cause;
    }
  }

  /** Reads a file whose writing is finished. @param outcome what became of it, where the file itself cannot say it */
  async read(id: string, outcome?: Outcome): Promise<Recording> {
    const read = (file: OpenFile): Promise<ListedFile> =>
      readListed(id, file, this.#context.limits, outcome);
    return this.#add(id, await this.#withFile(id, 'open', read));
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

  #add(id: string, file: ListedFile): Recording {
    this.#files.set(id, file);
    this.#context.onChange();
    return file.recording;
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

  /** The answer to the sender of an upload. The file of a node stays at the node. */
  async #refuse(
    job: RecordingJob,
    { kind, reason }: Exclude<Verdict, { kind: 'accepted' }>,
  ): Promise<ServiceError> {
    if (kind === 'refused') {
      const text = `The file is no recording: ${reason} Upload an MCAP file.`;
      return new ServiceError('invalid_argument', text);
    }
    if (job.isOfNode !== true) await this.#reject(job.id, 'upload', reason, job);
    return new ServiceError('invalid_argument', `The file cannot be read. ${reason}`);
  }

  /** [RC-45] */
  async #reject(
    id: string,
    from: 'recording' | 'upload',
    reason: string,
    job: Pick<RecordingJob, 'name' | 'author' | 'makerId'>,
  ): Promise<void> {
    const { folder, nowMs } = this.#context;
    const { name, author, makerId } = job;
    const rejection = { reason, name, author, makerId, rejectedMs: nowMs() };
    this.#add(id, listRejected(await folder.reject(id, from, rejection)));
  }

  async #scan(): Promise<void> {
    const { folder, checker } = this.#context;
    for (const file of await folder.rejected()) this.#files.set(file.id, listRejected(file));
    for (const id of await folder.list()) {
      if (this.#busy.has(id) || this.#files.has(id)) continue;
      try {
        const verdict = await checker.check({ id });
        if (verdict.kind === 'accepted') this.#add(id, verdict.file);
        else await this.#reject(id, 'recording', verdict.reason, UNKNOWN_MAKER);
      } catch {
        // It cannot be read or checked now: the next start tries again. [RC-7]
      }
    }
  }

  /** Works with files one after the other: the index of each takes memory. */
  #withFile<T>(id: string, how: 'open' | 'edit', work: (file: OpenFile) => Promise<T>): Promise<T> {
    const done = this.#queue.then(async () => {
      const file = await this.#context.folder[how](id);
      try {
        return await work(file);
      } finally {
        await file.close();
      }
    });
    this.#queue = done.catch(() => undefined);
    return done;
  }
}

const UNKNOWN_MAKER = { name: '', author: '', makerId: '' };

function isRejected({ state }: Recording): boolean {
  return state === RecordingState.RECORDING_STATE_REJECTED;
}

/** @throws ServiceError when its file was rejected [RC-45] */
function requireReadable(recording: Recording): void {
  if (!isRejected(recording)) return;
  const text = `${recording.problem} It can only be deleted.`;
  throw new ServiceError('failed_precondition', text);
}
