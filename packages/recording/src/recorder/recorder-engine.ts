import {
  RecordingKind,
  ServiceError,
  type FlightRecorder as FlightMessage,
  type Recording,
  type RecordingMarker,
} from '@ubii/proto';
import { RecordingWriter } from '../writing/recording-writer.ts';
import type { RecordingEvent } from '../records/recording-event.ts';
import type { Cancel, Clock } from '@ubii/timing';
import {
  FLIGHT_TARGET,
  type FlightJob,
  type KeptRecording,
  type MarkerJob,
  type Recorder,
  type RecorderList,
  type RecorderState,
  type RecordingJob,
  type RecordingTexts,
  type RecordingBatch,
  type RecordToKeep,
  type RunningJob,
  type RecordingPage,
} from './recorder.ts';
import { factsOf, formatHeader } from './file-facts.ts';
import { LocalChecker } from './check-file.ts';
import type { FileChecker } from './file-checker.ts';
import { FileList } from './file-list.ts';
import { FlightRecorder } from './flight-recorder.ts';
import { recordsOf } from './recording-batch.ts';
import { recordedOf } from './recorded-record.ts';
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

/** Records into files and into memory. The master runs it on a thread of its own. */
export class RecorderEngine implements Recorder {
  readonly #context: RecorderContext;
  readonly #flight: FlightRecorder;
  readonly #files: FileList;
  readonly #checker: FileChecker;
  readonly #running: RunningRecordings;
  #listener: (state: RecorderState) => void = () => undefined;
  #queue: Promise<unknown> = Promise.resolve();
  #waitingBytes = 0;
  #listRevision = 0;
  #ticks = 0;
  /** Something was recorded since the last tick. */
  #isActive = false;
  #cancelTick: Cancel | undefined = undefined;

  constructor(context: RecorderContext) {
    const { folder, clock, limits } = context;
    this.#context = context;
    this.#checker = context.checker ?? new LocalChecker(folder, limits);
    this.#flight = new FlightRecorder({
      clock,
      maxMarkers: limits.markersPerRecording,
      onDrop: () => this.#emit(),
    });
    this.#files = new FileList({
      folder,
      limits,
      checker: this.#checker,
      nowMs: () => this.#nowMs(),
      onChange: () => this.#listRevision++,
    });
    this.#running = new RunningRecordings({ ...context, files: this.#files });
  }

  get waitingBytes(): number {
    return this.#waitingBytes;
  }

  add(batch: RecordingBatch): void {
    void this.take(batch);
  }

  /** Like `add`; resolves when the records are taken in. */
  take(batch: RecordingBatch): Promise<void> {
    const bytes = batch.byteLength;
    this.#waitingBytes += bytes;
    this.#startTicks();
    return this.#inOrder(async () => {
      for (const record of recordsOf(batch)) this.#addRecord(record);
      await this.#running.taken();
      this.#waitingBytes -= bytes;
    });
  }

  endTopics(topics: readonly string[]): void {
    void this.#inOrder(() => {
      for (const topic of topics) this.#flight.forget(topic);
      return Promise.resolve();
    });
  }

  addEvent(event: RecordingEvent, targets: number): void {
    void this.#inOrder(() => {
      if ((targets & FLIGHT_TARGET) !== 0) this.#flight.addEvent(event);
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

  async mark(job: MarkerJob): Promise<RecordingMarker> {
    const { marker, mayChangeAll } = job;
    const isMarked = await this.#inOrder(() => Promise.resolve(this.#running.mark(job)));
    if (marker.recordingId === '') {
      if (!isMarked && !this.#flight.isOn) throw nothingToMark();
      this.#flight.mark(job);
    } else if (!isMarked) {
      if (!mayChangeAll) throw isFinished();
      await this.#files.mark(job);
    }
    this.#emit();
    return marker;
  }

  setFlight(job: FlightJob): Promise<FlightMessage> {
    return this.#inOrder(() => {
      this.#flight.set(job);
      this.#emit();
      return Promise.resolve(this.#flight.toMessage());
    });
  }

  flight(): Promise<FlightMessage> {
    return this.#inOrder(() => Promise.resolve(this.#flight.toMessage()));
  }

  async keep(job: RecordingJob): Promise<Recording> {
    await this.#inOrder(() => this.#writeFlight(job));
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

  onState(listener: (state: RecorderState) => void): void {
    this.#listener = listener;
  }

  async close(): Promise<void> {
    this.#cancelTick?.();
    await this.#checker.close();
    await this.#inOrder(() => {
      this.#flight.close();
      return this.#running.stopAll();
    });
  }

  /** Carries out one after the other. */
  #inOrder<T>(work: () => Promise<T>): Promise<T> {
    const done = this.#queue.then(work);
    this.#queue = done.catch(() => undefined);
    return done;
  }

  #addRecord({ source, record, timeMs, targets }: RecordToKeep): void {
    this.#isActive = true;
    const recorded = recordedOf(source, record, timeMs);
    if ((targets & FLIGHT_TARGET) !== 0) this.#flight.addRecord(recorded, timeMs);
    this.#running.addRecord(recorded, targets);
  }

  async #writeFlight(job: RecordingJob): Promise<void> {
    const { folder } = this.#context;
    try {
      const file = await this.#files.create(job.id);
      try {
        const facts = factsOf(job, RecordingKind.RECORDING_KIND_FLIGHT_RECORDER, this.#nowMs());
        const writer = await RecordingWriter.create(file, formatHeader(facts));
        await this.#flight.writeTo(writer);
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
    if (this.#running.size === 0 && !this.#isActive) return;
    this.#isActive = false;
    this.#ticks++;
    if (this.#running.size > 0) {
      await this.#running.flush();
      void this.#makeRoom();
      await this.#running.stopDue();
    }
    if (this.#ticks % 2 === 0) this.#emit();
    this.#startTicks();
  }

  #state(): RecorderState {
    const { targets } = this.#running;
    const running = this.#running.toMessages();
    const flight = this.#flight.toMessage();
    return { running, targets, flight, listRevision: this.#listRevision };
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
