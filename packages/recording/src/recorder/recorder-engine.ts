import {
  RecordingKind,
  ServiceError,
  type FlightRecords,
  type Recording,
  type RecordingMarker,
} from '@ubii/proto';
import { RecordingWriter } from '../writing/recording-writer.ts';
import type { RecordingEvent } from '../records/recording-event.ts';
import type { Cancel, Clock } from '@ubii/timing';
import type { NamedChannel } from '../arena/channels.ts';
import {
  erase,
  SharedReader,
  type RecordSpans,
  type SharedRecords,
} from '../arena/shared-records.ts';
import { findRecords, type FoundSpans } from './find-records.ts';
import type { FlightSnapshot } from './flight-recorder.ts';
import { writeFlight } from './write-flight.ts';
import type { FileRecorder, FileState } from './file-recorder.ts';
import type {
  KeptRecording,
  MarkerJob,
  RecorderList,
  RecordingJob,
  RecordingTexts,
  RunningJob,
  RecordingPage,
} from './recorder.ts';
import { factsOf, formatHeader } from './file-facts.ts';
import { LocalChecker } from './check-file.ts';
import type { FileChecker } from './file-checker.ts';
import { FileList } from './file-list.ts';
import { recordedOf } from '../records/recorded-record.ts';
import type { RecorderLimits } from './recorder-limits.ts';
import type { RecordingFolder } from './recording-folder.ts';
import { notWritten, RunningRecordings } from './running-recordings.ts';

/** What a recorder works with. */
export interface RecorderContext {
  readonly folder: RecordingFolder;
  readonly clock: Clock;
  readonly limits: RecorderLimits;
  /** Checks files that others wrote. @default this thread does it */
  readonly checker?: FileChecker;
}

/** Time between two looks at what runs, milliseconds: chunks end with it, so that a crash loses less than a second [RC-7]. */
const TICK_MS = 500;

/** Records are read for files in pieces of this many: other calls come in between. */
const RECORDS_A_TURN = 1000;

/** Writes files of what it reads in shared memory. The master runs it on a thread of its own. */
export class RecorderEngine implements FileRecorder {
  readonly #context: RecorderContext;
  readonly #files: FileList;
  readonly #checker: FileChecker;
  readonly #running: RunningRecordings;
  /** Names of channels, by number. */
  readonly #channels = new Map<number, NamedChannel>();
  #memory: SharedRecords | undefined = undefined;
  #reader: SharedReader | undefined = undefined;
  #listener: (state: FileState) => void = () => undefined;
  #queue: Promise<unknown> = Promise.resolve();
  #listRevision = 0;
  #ticks = 0;
  #cancelTick: Cancel | undefined = undefined;

  constructor(context: RecorderContext) {
    const { folder, limits } = context;
    this.#context = context;
    this.#checker = context.checker ?? new LocalChecker(folder, limits);
    this.#files = new FileList({
      folder,
      limits,
      checker: this.#checker,
      nowMs: () => this.#nowMs(),
      onChange: () => this.#listRevision++,
    });
    this.#running = new RunningRecordings({ ...context, files: this.#files });
  }

  readonly generation = 0;

  open(memory: SharedRecords): void {
    void this.#inOrder(() => {
      this.#memory = memory;
      this.#reader = new SharedReader(memory);
      return Promise.resolve();
    });
  }

  erase(memory: SharedRecords): void {
    void this.#inOrder(() => {
      erase(memory);
      return Promise.resolve();
    });
  }

  read(spans: RecordSpans, channels: readonly NamedChannel[]): Promise<void> {
    return this.#inOrder(async () => {
      for (const channel of channels) this.#channels.set(channel.number, channel);
      if (this.#running.size === 0) return;
      const wanted = this.#running.targets;
      let count = 0;
      for (const { channel, record, targets, timeMs } of this.#reader?.read(spans) ?? []) {
        const source = this.#channels.get(channel);
        if ((targets & wanted) === 0 || source === undefined) continue;
        this.#running.addRecord(recordedOf(source, record, timeMs), targets);
        if (++count % RECORDS_A_TURN === 0) await this.#running.taken();
      }
      await this.#running.taken();
    });
  }

  addEvent(event: RecordingEvent, targets: number): void {
    void this.#inOrder(() => {
      this.#running.addEvent(event, targets);
      return Promise.resolve();
    });
  }

  start(job: RunningJob): Promise<Recording> {
    return this.#inOrder(async () => {
      const recording = await this.#running.start(job);
      this.#emit();
      this.#startTicks();
      return recording;
    });
  }

  async stop(id: string): Promise<Recording> {
    await this.#inOrder(() => this.#running.stop(id));
    await this.#makeRoom();
    this.#emit();
    return (await this.#files.get(id)).recording;
  }

  async list(): Promise<RecorderList> {
    await this.#files.scan();
    const freeBytes = await this.#context.folder.freeBytes();
    // While its file is being closed, a recording is neither among those that run nor in the list.
    return this.#inOrder(() => {
      const recordings = [...this.#running.toMessages(), ...this.#files.values()];
      const makers = new Map([...this.#files.makers(), ...this.#running.makers()]);
      const sizeBytes = this.#files.sizeBytes + this.#running.sizeBytes;
      return Promise.resolve({ recordings, makers, sizeBytes, freeBytes });
    });
  }

  async get(id: string, page?: RecordingPage): Promise<KeptRecording> {
    const running = await this.#inOrder(() => Promise.resolve(this.#running.get(id, page)));
    return running ?? this.#files.get(id, page);
  }

  async makerOf(id: string): Promise<string> {
    const running = await this.#inOrder(() => Promise.resolve(this.#running.makerOf(id)));
    return running ?? this.#files.makerOf(id);
  }

  async change(id: string, texts: RecordingTexts): Promise<Recording> {
    const running = this.#running.change(id, texts);
    const changed = running ?? (await this.#files.change(id, texts));
    this.#emit();
    return changed;
  }

  async delete(id: string): Promise<void> {
    await this.#inOrder(() => this.#running.stop(id));
    await this.#files.delete(id);
    this.#emit();
  }

  async mark(job: MarkerJob, isFlightOn: boolean): Promise<RecordingMarker> {
    const { marker, mayChangeAll } = job;
    const isMarked = await this.#inOrder(() => Promise.resolve(this.#running.mark(job)));
    if (marker.recordingId === '') {
      if (!isMarked && !isFlightOn) throw nothingToMark();
    } else if (!isMarked) {
      if (!mayChangeAll) throw isFinished();
      await this.#files.mark(job);
    }
    this.#emit();
    return marker;
  }

  find(search: FoundSpans): Promise<FlightRecords> {
    return this.#inOrder(() =>
      Promise.resolve(findRecords(this.#reader?.read(search.spans) ?? [], search)),
    );
  }

  async keep(job: RecordingJob, snapshot: FlightSnapshot): Promise<Recording> {
    await this.#inOrder(() => this.#writeFlight(job, snapshot));
    const recording = await this.#files.read(job.id);
    await this.#makeRoom();
    this.#emit();
    return recording;
  }

  async adopt(job: RecordingJob): Promise<Recording> {
    const recording = await this.#files.adopt(job, this.#nowMs());
    this.#emit();
    return recording;
  }

  onState(listener: (state: FileState) => void): void {
    this.#listener = listener;
  }

  async close(): Promise<void> {
    this.#cancelTick?.();
    await this.#checker.close();
    await this.#inOrder(() => this.#running.stopAll());
  }

  /** Carries out one after the other. */
  #inOrder<T>(work: () => Promise<T>): Promise<T> {
    const done = this.#queue.then(work);
    this.#queue = done.catch(() => undefined);
    return done;
  }

  async #writeFlight(job: RecordingJob, snapshot: FlightSnapshot): Promise<void> {
    const { folder } = this.#context;
    try {
      const file = await this.#files.create(job.id);
      try {
        const facts = factsOf(job, RecordingKind.RECORDING_KIND_FLIGHT_RECORDER, this.#nowMs());
        const writer = await RecordingWriter.create(file, formatHeader(facts));
        // All at once: what is not copied yet may be overwritten.
        const reader = this.#memory && new SharedReader(this.#memory, Infinity);
        await writeFlight(snapshot, reader, writer);
        await writer.end();
      } finally {
        await file.close();
      }
    } catch (cause) {
      await folder.delete(job.id).catch(() => undefined);
      throw notWritten(cause);
    } finally {
      this.#files.release(job.id);
    }
  }

  #makeRoom(): Promise<void> {
    return this.#files.makeRoom(this.#context.limits.recordingsBytes, this.#running.sizeBytes);
  }

  #nowMs(): number {
    return this.#context.clock.nowMs();
  }

  #startTicks(): void {
    this.#cancelTick ??= this.#context.clock.after(TICK_MS, () => {
      void this.#inOrder(() => this.#tick());
    });
  }

  async #tick(): Promise<void> {
    this.#cancelTick = undefined;
    if (this.#running.size === 0) return;
    this.#ticks++;
    await this.#running.flush();
    void this.#makeRoom();
    await this.#running.stopDue();
    if (this.#ticks % 2 === 0) this.#emit();
    this.#startTicks();
  }

  #state(): FileState {
    const { targets } = this.#running;
    const running = this.#running.toMessages();
    return { running, targets, listRevision: this.#listRevision };
  }

  #emit(): void {
    this.#listener(this.#state());
  }
}

function nothingToMark(): ServiceError {
  return new ServiceError(
    'failed_precondition',
    'Nothing is being recorded, and the flight recorder is off. Start a recording, or name one with `recording_id`.',
  );
}

/** [RC-21] */
function isFinished(): ServiceError {
  return new ServiceError(
    'permission_denied',
    'This recording is finished. Only its maker and admins may change its markers.',
  );
}
