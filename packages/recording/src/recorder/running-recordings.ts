import { RecordingState, ServiceError, type Recording } from '@ubii/proto';
import type { RecordedRecord } from '../records/recorded-record.ts';
import type { RecordingEvent } from '../records/recording-event.ts';
import type { Clock } from '@ubii/timing';
import type {
  KeptRecording,
  MarkerJob,
  RecordingTexts,
  RunningJob,
  RecordingPage,
} from './recorder.ts';
import type { FileList } from './file-list.ts';
import type { RecorderLimits } from './recorder-limits.ts';
import type { RecordingFolder } from './recording-folder.ts';
import { pageOf } from './recording-page.ts';
import { RunningRecording } from './running-recording.ts';

/** What running recordings need. */
export interface RunningContext {
  readonly folder: RecordingFolder;
  readonly clock: Clock;
  readonly files: FileList;
  readonly limits: RecorderLimits;
}

/** Recordings whose files are being written. */
export class RunningRecordings {
  readonly #context: RunningContext;
  readonly #running = new Map<string, RunningRecording>();
  readonly #failures = new Map<RunningRecording, unknown>();

  constructor(context: RunningContext) {
    this.#context = context;
  }

  get size(): number {
    return this.#running.size;
  }

  get sizeBytes(): number {
    return [...this.#running.values()].reduce((sum, { sizeBytes }) => sum + sizeBytes, 0);
  }

  /** Bits of all that run. */
  get targets(): number {
    return [...this.#running.values()].reduce((bits, { job }) => bits | job.target, 0);
  }

  /** The newest first. */
  toMessages(): Recording[] {
    const nowMs = this.#nowMs();
    return [...this.#running.values()].map((each) => each.toMessage(nowMs)).reverse();
  }

  /** By id of the recording. */
  makers(): [id: string, makerId: string][] {
    return [...this.#running].map(([id, { job }]) => [id, job.makerId]);
  }

  makerOf(id: string): string | undefined {
    return this.#running.get(id)?.job.makerId;
  }

  /** @param page of topics and markers; default: neither */
  get(id: string, page?: RecordingPage): KeptRecording | undefined {
    const running = this.#running.get(id);
    if (running === undefined) return undefined;
    const { topics, job } = running;
    const parts = { topics, markers: running.markers.values() };
    const recording = {
      ...running.toMessage(this.#nowMs()),
      ...(page && pageOf(id, parts, page, this.#context.limits)),
    };
    return { recording, makerId: job.makerId };
  }

  /** @throws ServiceError when the file cannot be created */
  async start(job: RunningJob): Promise<Recording> {
    const { folder, files, limits } = this.#context;
    const nowMs = this.#nowMs();
    try {
      const file = await files.create(job.id);
      const running = await RunningRecording.create(job, file, nowMs, limits.markersPerRecording);
      this.#running.set(job.id, running);
      return running.toMessage(nowMs);
    } catch (cause) {
      files.release(job.id);
      await folder.delete(job.id).catch(() => undefined);
      throw notWritten(cause);
    }
  }

  addRecord(record: RecordedRecord, targets: number): void {
    for (const running of this.#running.values()) {
      if ((targets & running.job.target) !== 0)
        this.#write(running, () => running.addRecord(record));
    }
  }

  addEvent(event: RecordingEvent, targets: number): void {
    for (const running of this.#running.values()) {
      if ((targets & running.job.target) !== 0) this.#write(running, () => running.addEvent(event));
    }
  }

  /** Marks one, or all. @returns false when none runs @throws ServiceError when a marker is refused */
  mark(job: MarkerJob): boolean {
    const { recordingId } = job.marker;
    const all = [...this.#running.values()];
    const marked = recordingId === '' ? all : all.filter((each) => each.job.id === recordingId);
    for (const running of marked) {
      const event = running.markers.apply(job);
      this.#write(running, () => running.addEvent(event));
    }
    return marked.length > 0;
  }

  change(id: string, texts: RecordingTexts): Recording | undefined {
    const running = this.#running.get(id);
    running?.change(texts);
    return running?.toMessage(this.#nowMs());
  }

  /** Waits until the files took what they were given; ends recordings whose file failed. */
  async taken(): Promise<void> {
    for (const running of this.#running.values()) await this.#try(running, () => running.taken());
    await this.#endFailed();
  }

  async flush(): Promise<void> {
    for (const running of this.#running.values()) await this.#try(running, () => running.flush());
    await this.#endFailed();
  }

  /** Closes the file, if it runs. @param problem why it stops by itself */
  async stop(id: string, problem = ''): Promise<void> {
    const running = this.#running.get(id);
    if (running === undefined) return;
    await this.#try(running, () => running.finish(problem));
    await this.#endFailed();
    if (!this.#running.delete(id)) return;
    this.#context.files.release(id);
    await this.#context.files.read(id);
  }

  async stopAll(): Promise<void> {
    for (const id of [...this.#running.keys()]) await this.stop(id);
  }

  /** Stops what has used up its budget. [RC-16] */
  async stopDue(): Promise<void> {
    const freeBytes = await this.#context.folder.freeBytes();
    for (const [id, running] of [...this.#running]) {
      const reason = this.#reasonToStop(running, freeBytes);
      if (reason !== undefined) await this.stop(id, `The recording stopped: ${reason}.`);
    }
  }

  #reasonToStop(running: RunningRecording, free: number): string | undefined {
    const { job, startedMs, sizeBytes } = running;
    const { maxDurationMs, maxBytes, minFreeBytes } = job.budget;
    const { files, limits } = this.#context;
    if (this.#nowMs() - startedMs >= maxDurationMs) return 'it reached its longest duration';
    if (sizeBytes >= maxBytes) return 'its file reached its largest size';
    if (running.isIndexFull) return 'its index reached its largest size';
    if (free > 0 && free < minFreeBytes) return 'little space is free on the disk';
    const allBytes = files.sizeBytes + this.sizeBytes;
    return allBytes > limits.recordingsBytes ? 'all recordings take too much space' : undefined;
  }

  #write(running: RunningRecording, write: () => void): void {
    try {
      write();
    } catch (cause) {
      this.#failures.set(running, cause);
    }
  }

  async #try(running: RunningRecording, work: () => Promise<void>): Promise<void> {
    try {
      await work();
    } catch (cause) {
      this.#failures.set(running, cause);
    }
  }

  /** [RC-17] */
  async #endFailed(): Promise<void> {
    const failures = [...this.#failures];
    this.#failures.clear();
    for (const [running, cause] of failures) {
      const { id } = running.job;
      if (!this.#running.delete(id)) continue;
      const problem = `The file could not be written: ${textOf(cause)}. What was written before is kept.`;
      const { files } = this.#context;
      // The disk may have no room for the end of the file either: the next start repairs it. [RC-7]
      await running.salvage(problem).catch(() => undefined);
      files.release(id);
      const state = RecordingState.RECORDING_STATE_FAILED;
      await files.read(id, { state, problem }).catch(() => undefined);
    }
  }

  #nowMs(): number {
    return this.#context.clock.nowMs();
  }
}

/** The error of a service whose file could not be written. */
export function notWritten(cause: unknown): ServiceError {
  return new ServiceError(
    'failed_precondition',
    `The recording could not be written: ${textOf(cause)}. Delete files on the disk, or use another data directory.`,
  );
}

function textOf(cause: unknown): string {
  return cause instanceof Error ? cause.message : String(cause);
}
