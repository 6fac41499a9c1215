import type { Worker } from 'node:worker_threads';
import {
  ServiceError,
  type FlightRecorder,
  type Recording,
  type RecordingMarker,
} from '@ubii/proto';
import type { Cancel, Clock } from '@ubii/timing';
import type { RecordingEvent } from '../records/recording-event.ts';
import type {
  FlightJob,
  KeptRecording,
  MarkerJob,
  Recorder,
  RecorderList,
  RecorderState,
  RecordingJob,
  RecordingTexts,
  RecordSource,
  RecordingBatch,
  RunningJob,
  RecordingPage,
} from '../recorder/recorder.ts';
import { openThread } from './open-thread.ts';
import type {
  FromThread,
  RecorderCalls,
  RecorderMethod,
  RecorderThreadData,
  ToThread,
} from './thread-messages.ts';

export interface WorkerRecorderOptions extends Omit<RecorderThreadData, 'checkProcessFile'> {
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

/** Heap of the thread: twice what the longest index takes. The flight recorder has its memory besides. */
const HEAP_MIB = 1024;
/** Time after a failure until the thread may start again. */
const PAUSE_MS = 5_000;
/** From so many sources on, the thread forgets all that it knows. */
const MAX_SOURCES = 100_000;
const OFF: FlightRecorder = {
  ...{ isOn: false, minutes: 0, maxBytes: 0, withImages: false, heldMs: 0, heldBytes: 0 },
  ...{ topicCount: 0, recordCount: 0, recordsPerSecond: [], lostCount: 0 },
};

/** A recorder on a thread of its own, which starts when it is first needed. [RC-50] */
export class WorkerRecorder implements Recorder {
  readonly #options: WorkerRecorderOptions;
  readonly #calls = new Map<number, Call>();
  #worker: Worker | undefined = undefined;
  #numbers = new Map<RecordSource, number>();
  #isFresh = true;
  #nextCall = 0;
  #waitingBytes = 0;
  /** Until then, the thread is not started again, monotonic milliseconds. */
  #pausedUntilMs = 0;
  #cancelPauseEnd: Cancel = () => undefined;
  /** What the flight recorder keeps, for the next thread. */
  #flightJob: FlightJob | undefined = undefined;
  #listRevision = 0;
  #listener: (state: RecorderState) => void = () => undefined;

  constructor(options: WorkerRecorderOptions) {
    this.#options = options;
  }

  get waitingBytes(): number {
    return this.#waitingBytes;
  }

  add({ sources, ...batch }: RecordingBatch): void {
    if (this.#isPaused) return;
    if (this.#numbers.size > MAX_SOURCES) {
      this.#numbers = new Map();
      this.#isFresh = true;
    }
    const added: RecordSource[] = [];
    const numbers = sources.map((source) => this.#numberOf(source, added));
    this.#waitingBytes += batch.byteLength;
    const message: ToThread = { kind: 'batch', batch, numbers, added, isFresh: this.#isFresh };
    const large = batch.large.map(({ buffer }) => buffer);
    this.#send(message, [batch.heads.buffer, batch.bytes.buffer, ...large]);
    this.#isFresh = false;
  }

  endTopics(topics: readonly string[]): void {
    if (!this.#isPaused) this.#send({ kind: 'ended', topics });
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

  mark(job: MarkerJob): Promise<RecordingMarker> {
    return this.#call('mark', job);
  }

  setFlight(job: FlightJob): Promise<FlightRecorder> {
    this.#flightJob = job;
    return this.#call('setFlight', job);
  }

  flight(): Promise<FlightRecorder> {
    return this.#call('flight');
  }

  keep(job: RecordingJob): Promise<Recording> {
    return this.#call('keep', job);
  }

  adopt(job: RecordingJob): Promise<Recording> {
    return this.#call('adopt', job);
  }

  onState(listener: (state: RecorderState) => void): void {
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

  /** The number that the thread knows a source by; new sources go into `added`. */
  #numberOf(source: RecordSource, added: RecordSource[]): number {
    let number = this.#numbers.get(source);
    if (number === undefined) {
      number = this.#numbers.size;
      this.#numbers.set(source, number);
      added.push({ topic: source.topic, clientId: source.clientId });
    }
    return number;
  }

  #send(message: ToThread, transfer: ArrayBuffer[] = []): void {
    try {
      this.#worker ??= this.#startThread();
      this.#worker.postMessage(message, transfer);
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
      case 'taken':
        this.#waitingBytes -= message.bytes;
        return;
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
    this.#numbers = new Map();
    this.#isFresh = true;
    this.#waitingBytes = 0;
    for (const { reject } of this.#calls.values()) reject(unavailable());
    this.#calls.clear();
    this.#tellIdle();
    this.#cancelPauseEnd();
    this.#cancelPauseEnd = this.#options.clock.after(PAUSE_MS, () => this.#handlePauseEnd());
  }

  #handlePauseEnd(): void {
    // What was recorded can be listed again.
    if (this.#worker === undefined) this.#tellIdle();
    const job = this.#flightJob;
    if (job !== undefined) void this.setFlight(job).catch(() => undefined);
  }

  #tellIdle(): void {
    const listRevision = ++this.#listRevision;
    this.#listener({ running: [], targets: 0, flight: OFF, listRevision });
  }
}

function unavailable(): ServiceError {
  return new ServiceError(
    'unavailable',
    'The recorder failed and starts again within seconds. Try again; the log says why.',
  );
}
