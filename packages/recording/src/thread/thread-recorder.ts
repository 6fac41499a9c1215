import type { Worker } from 'node:worker_threads';
import {
  ServiceError,
  type FlightRecords,
  type Recording,
  type RecordingMarker,
} from '@ubii/proto';
import type { Cancel, Clock } from '@ubii/timing';
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
import { openThread } from './open-thread.ts';
import { partsOf } from './snapshot-parts.ts';
import type {
  FromThread,
  RecorderCalls,
  RecorderMethod,
  RecorderThreadData,
  ToThread,
} from './thread-messages.ts';

export interface ThreadRecorderOptions extends Omit<RecorderThreadData, 'checkProcessFile'> {
  /** The built thread. */
  readonly workerFile: URL;
  /** The built process that checks files. [RC-44] */
  readonly checkProcessFile: URL;
  readonly clock: Clock;
  /** Is told what failed, for the log. @param reason what went wrong */
  readonly onFailure: (what: string, reason: string) => void;
}

interface Call {
  readonly resolve: (value: unknown) => void;
  readonly reject: (error: ServiceError) => void;
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
  readonly #calls = new Map<number, Call>();
  #worker: Worker | undefined = undefined;
  #generation = 0;
  #nextCall = 0;
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
    if (!this.#isPaused) this.#send({ kind: 'open', memory });
  }

  erase(memory: SharedRecords): void {
    if (!this.#isPaused) this.#send({ kind: 'erase', memory });
  }

  read(spans: RecordSpans, channels: readonly NamedChannel[]): Promise<void> {
    return this.#call('read', spans, channels);
  }

  addEvent(event: RecordingEvent, targets: number): void {
    if (!this.#isPaused) this.#send({ kind: 'event', event, targets });
  }

  start(job: RunningJob): Promise<Recording> {
    return this.#call('start', job);
  }

  stop(id: string): Promise<Recording> {
    return this.#call('stop', id);
  }

  list(): Promise<RecorderList> {
    return this.#call('list');
  }

  get(id: string, page?: RecordingPage): Promise<KeptRecording> {
    return this.#call('get', id, page);
  }

  makerOf(id: string): Promise<string> {
    return this.#call('makerOf', id);
  }

  change(id: string, texts: RecordingTexts): Promise<Recording> {
    return this.#call('change', id, texts);
  }

  delete(id: string): Promise<void> {
    return this.#call('delete', id);
  }

  mark(job: MarkerJob, isFlightOn: boolean): Promise<RecordingMarker> {
    return this.#call('mark', job, isFlightOn);
  }

  find(search: FoundSpans): Promise<FlightRecords> {
    return this.#call('find', search);
  }

  keep(job: RecordingJob, snapshot: FlightSnapshot): Promise<Recording> {
    const kept = this.#kept.then(() => this.#sendSnapshot(job, snapshot));
    this.#kept = kept.catch(() => undefined);
    return kept;
  }

  adopt(job: RecordingJob): Promise<Recording> {
    return this.#call('adopt', job);
  }

  onState(listener: (state: FileState) => void): void {
    this.#listener = listener;
  }

  async close(): Promise<void> {
    this.#cancelPauseEnd();
    const worker = this.#worker;
    if (worker === undefined) return;
    worker.ref(); // Nothing else may keep the process until the files are closed.
    await this.#call('close').catch(() => undefined);
    this.#worker = undefined;
    await worker.terminate();
  }

  get #isPaused(): boolean {
    return this.#options.clock.monotonicMs() < this.#pausedUntilMs;
  }

  #call<M extends RecorderMethod>(
    method: M,
    ...args: Parameters<RecorderCalls[M]>
  ): ReturnType<RecorderCalls[M]> {
    const id = this.#nextCall++;
    return new Promise<unknown>((resolve, reject) => {
      if (this.#isPaused) return reject(unavailable());
      this.#calls.set(id, { resolve, reject });
      this.#send({ kind: 'call', id, method, args });
    }) as ReturnType<RecorderCalls[M]>;
  }

  async #sendSnapshot(job: RecordingJob, snapshot: FlightSnapshot): Promise<Recording> {
    const generation = this.#generation;
    for (const part of partsOf(snapshot)) {
      if (this.#isPaused || generation !== this.#generation) throw unavailable();
      this.#send({ kind: 'part', part });
      await new Promise<void>((resolve) => this.#options.clock.after(0, resolve));
    }
    return this.#call('keep', job, { ...snapshot, channels: [], standing: [], events: [] });
  }

  #send(message: ToThread): void {
    try {
      this.#worker ??= this.#startThread();
      this.#worker.postMessage(message);
    } catch (error) {
      this.#fail(String(error));
    }
  }

  #startThread(): Worker {
    const { workerFile, folder, limits, checkProcessFile } = this.#options;
    const workerData: RecorderThreadData = {
      ...{ folder, limits, checkProcessFile: checkProcessFile.href },
    };
    const worker: Worker = openThread<FromThread>({
      ...{ workerFile, name: 'ubii recorder', workerData, heapMib: HEAP_MIB },
      onMessage: (message) => {
        if (this.#worker === worker) this.#handle(message);
      },
      onEnd: (reason) => {
        if (this.#worker === worker) this.#fail(reason);
      },
    });
    return worker;
  }

  #handle(message: FromThread): void {
    switch (message.kind) {
      case 'state':
        this.#listRevision = message.state.listRevision;
        return this.#listener(message.state);
      case 'reply':
        return this.#takeCall(message.id)?.resolve(message.value);
      case 'refusal':
        return this.#refuse(message);
    }
  }

  #refuse({ id, code, message, details, cause }: Extract<FromThread, { kind: 'refusal' }>): void {
    if (code === 'internal') this.#options.onFailure('the recorder failed', cause);
    this.#takeCall(id)?.reject(new ServiceError(code, message, { details }));
  }

  #takeCall(id: number): Call | undefined {
    const call = this.#calls.get(id);
    this.#calls.delete(id);
    return call;
  }

  /** What was recorded is repaired by the next thread. The program goes on. */
  #fail(reason: string): void {
    const worker = this.#worker;
    this.#worker = undefined;
    void worker?.terminate();
    this.#options.onFailure('recording stopped, because its thread failed', reason);
    this.#pausedUntilMs = this.#options.clock.monotonicMs() + PAUSE_MS;
    this.#generation++;
    for (const { reject } of this.#calls.values()) reject(unavailable());
    this.#calls.clear();
    this.#tellIdle();
    this.#cancelPauseEnd();
    this.#cancelPauseEnd = this.#options.clock.after(PAUSE_MS, () => this.#handlePauseEnd());
  }

  #handlePauseEnd(): void {
    // What was recorded can be listed again.
    if (this.#worker === undefined) this.#tellIdle();
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
