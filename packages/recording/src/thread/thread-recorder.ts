import {
  ServiceError,
  type FlightRecords,
  type Recording,
  type RecordingMarker,
} from '@ubii/proto';
import type { Cancel, Clock } from '@ubii/timing';
import { openThread, type Calls, type Thread } from '@ubii/worker-rpc/node';
import type { NamedChannel } from '../arena/channels.ts';
import type { RecordSpans, SharedRecords } from '../arena/shared-records.ts';
import type { FoundSpans } from '../recorder/find-records.ts';
import type { FlightSnapshot } from '../recorder/flight-recorder.ts';
import type { FileRecorder, FileState } from '../recorder/file-recorder.ts';
import type {
  KeptRecording,
  MarkerJob,
  RecorderList,
  RecordingJob,
  RecordingTexts,
  RunningJob,
  RecordingPage,
} from '../recorder/recorder.ts';
import { SharedRecorder, type MemoryLimits } from '../recorder/shared-recorder.ts';
import type { RecordingEvent } from '../records/recording-event.ts';
import { partsOf } from './snapshot-parts.ts';
import type { RecorderOwner, RecorderThread, RecorderThreadData } from './thread-messages.ts';

export interface ThreadRecorderOptions extends Omit<RecorderThreadData, 'checkProcessFile'> {
  /** The built thread. */
  readonly workerFile: URL;
  /** The built process that checks files. [RC-44] */
  readonly checkProcessFile: URL;
  readonly clock: Clock;
  /** Is told what failed, for the log. @param reason what went wrong */
  readonly onFailure: (what: string, reason: string) => void;
}

/** Heap of the thread: twice what the longest index takes. */
const HEAP_MIB = 1024;
/** Time after a failure until the thread may start again. */
const PAUSE_MS = 5_000;
/** A recorder whose files are written by a thread of its own. [RC-50] */
export function recordOnThread(
  options: ThreadRecorderOptions & { readonly limits: MemoryLimits },
): SharedRecorder {
  const { clock, limits } = options;
  return new SharedRecorder({ clock, limits, files: new ThreadRecorder(options) });
}

/** Writes files on a thread of its own, which starts when it is first needed. */
export class ThreadRecorder implements FileRecorder {
  readonly #options: ThreadRecorderOptions;
  #thread: Thread<RecorderThread> | undefined = undefined;
  #generation = 0;
  /** Until then, the thread is not started again, monotonic milliseconds. */
  #pausedUntilMs = 0;
  #cancelPauseEnd: Cancel = () => undefined;
  /** One snapshot after the other is sent, in parts. */
  #kept: Promise<unknown> = Promise.resolve();
  #listRevision = 0;
  #listener: (state: FileState) => void = () => undefined;

  constructor(options: ThreadRecorderOptions) {
    this.#options = options;
  }

  get generation(): number {
    return this.#generation;
  }

  open(memory: SharedRecords): void {
    this.#notify((thread) => thread.open(memory));
  }

  erase(memory: SharedRecords): void {
    this.#notify((thread) => thread.erase(memory));
  }

  read(spans: RecordSpans, channels: readonly NamedChannel[]): Promise<void> {
    return this.#call((thread) => thread.read(spans, channels));
  }

  addEvent(event: RecordingEvent, targets: number): void {
    this.#notify((thread) => thread.addEvent(event, targets));
  }

  start(job: RunningJob): Promise<Recording> {
    return this.#call((thread) => thread.start(job));
  }

  stop(id: string): Promise<Recording> {
    return this.#call((thread) => thread.stop(id));
  }

  list(): Promise<RecorderList> {
    return this.#call((thread) => thread.list());
  }

  get(id: string, page?: RecordingPage): Promise<KeptRecording> {
    return this.#call((thread) => thread.get(id, page));
  }

  makerOf(id: string): Promise<string> {
    return this.#call((thread) => thread.makerOf(id));
  }

  change(id: string, texts: RecordingTexts): Promise<Recording> {
    return this.#call((thread) => thread.change(id, texts));
  }

  delete(id: string): Promise<void> {
    return this.#call((thread) => thread.delete(id));
  }

  mark(job: MarkerJob, isFlightOn: boolean): Promise<RecordingMarker> {
    return this.#call((thread) => thread.mark(job, isFlightOn));
  }

  find(search: FoundSpans): Promise<FlightRecords> {
    return this.#call((thread) => thread.find(search));
  }

  keep(job: RecordingJob, snapshot: FlightSnapshot): Promise<Recording> {
    const kept = this.#kept.then(() => this.#sendSnapshot(job, snapshot));
    this.#kept = kept.catch(() => undefined);
    return kept;
  }

  adopt(job: RecordingJob): Promise<Recording> {
    return this.#call((thread) => thread.adopt(job));
  }

  onState(listener: (state: FileState) => void): void {
    this.#listener = listener;
  }

  async close(): Promise<void> {
    this.#cancelPauseEnd();
    const thread = this.#thread;
    if (thread === undefined) return;
    thread.ref(); // Nothing else may keep the process until the files are closed.
    await thread.calls.close().catch(() => undefined);
    this.#thread = undefined;
    await thread.end('it was closed');
  }

  get #isPaused(): boolean {
    return this.#options.clock.monotonicMs() < this.#pausedUntilMs;
  }

  async #call<T>(call: (thread: Calls<RecorderThread>) => Promise<T>): Promise<T> {
    if (this.#isPaused) throw unavailable();
    this.#thread ??= this.#startThread();
    try {
      return await call(this.#thread.calls);
    } catch (error) {
      const { code, cause } = ServiceError.from(error);
      if (code === 'internal') this.#options.onFailure('the recorder failed', String(cause));
      throw error;
    }
  }

  /** Calls without a result. A thread that fails says so by its end. */
  #notify(call: (thread: Calls<RecorderThread>) => Promise<void>): void {
    this.#call(call).catch(() => undefined);
  }

  async #sendSnapshot(job: RecordingJob, snapshot: FlightSnapshot): Promise<Recording> {
    const generation = this.#generation;
    for (const part of partsOf(snapshot)) {
      if (this.#isPaused || generation !== this.#generation) throw unavailable();
      this.#notify((thread) => thread.addPart(part));
      await new Promise<void>((resolve) => this.#options.clock.after(0, resolve));
    }
    return this.#call((thread) =>
      thread.keep(job, { ...snapshot, channels: [], standing: [], events: [] }),
    );
  }

  #startThread(): Thread<RecorderThread> {
    const { workerFile, folder, limits, checkProcessFile } = this.#options;
    const workerData: RecorderThreadData = {
      folder,
      limits,
      checkProcessFile: checkProcessFile.href,
    };
    const owner: RecorderOwner = {
      showState: (state) => {
        this.#listRevision = state.listRevision;
        this.#listener(state);
      },
    };
    return openThread(
      {
        workerFile,
        name: 'ubii recorder',
        workerData,
        heapMib: HEAP_MIB,
        onEnd: (reason) => this.#fail(reason),
        lost: unavailable,
      },
      owner,
    );
  }

  /** What was recorded is repaired by the next thread. The program goes on. */
  #fail(reason: string): void {
    this.#thread = undefined;
    this.#options.onFailure('recording stopped, because its thread failed', reason);
    this.#pausedUntilMs = this.#options.clock.monotonicMs() + PAUSE_MS;
    this.#generation++;
    this.#tellIdle();
    this.#cancelPauseEnd();
    this.#cancelPauseEnd = this.#options.clock.after(PAUSE_MS, () => this.#handlePauseEnd());
  }

  #handlePauseEnd(): void {
    // What was recorded can be listed again.
    if (this.#thread === undefined) this.#tellIdle();
  }

  #tellIdle(): void {
    const listRevision = ++this.#listRevision;
    this.#listener({ running: [], targets: 0, listRevision });
  }
}

function unavailable(): ServiceError {
  return new ServiceError(
    'unavailable',
    'The recorder failed and starts again within seconds. Try again; the log says why.',
  );
}
