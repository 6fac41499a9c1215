import type {
  FlightRecorder as FlightMessage,
  FlightRecords,
  Recording,
  RecordingMarker,
} from '@ubii/proto';
import type { Cancel, Clock } from '@ubii/timing';
import type { ChannelSource } from '../arena/channels.ts';
import { FLIGHT_TARGET, SharedReader, type RecordSpans } from '../arena/shared-records.ts';
import { RecordMemory, type MemoryBounds } from '../arena/record-memory.ts';
import type { RecordSearch } from './find-records.ts';
import { FlightRecorder } from './flight-recorder.ts';
import type { RecordingEvent } from '../records/recording-event.ts';
import { gapEvent } from './facts.ts';
import type { FileRecorder, FileState } from './file-recorder.ts';
import {
  type FlightJob,
  type KeptRecording,
  type MarkerJob,
  type Recorder,
  type RecorderList,
  type RecorderState,
  type RecordingJob,
  type RecordingPage,
  type RecordingTexts,
  type RunningJob,
} from './recorder.ts';

/** Limits of what is in memory. */
export interface MemoryLimits {
  /** Bytes of records on their way into files. */
  readonly recorderQueueBytes: number;
  readonly markersPerRecording: number;
}

/** What a recorder works with. */
export interface SharedRecorderContext {
  readonly clock: Clock;
  readonly files: FileRecorder;
  readonly limits: MemoryLimits;
}

/** Memory that was announced to files. */
interface OpenedMemory {
  readonly memory: RecordMemory;
  readonly generation: number;
  /** They know the names of its channels. */
  hasNames: boolean;
}

/** Longest time that records wait for files, milliseconds. */
const READ_MS = 50;
/** Bytes of records from which on files read them before their time. */
const READ_BYTES = 4 * 1024 * 1024;
/** With less memory to be had, nothing else would work either. */
const MIN_BYTES = 1024 * 1024;
/** Between two reports while the flight recorder takes records. [RC-8] */
const REPORT_MS = 1000;
const TOO_SLOW = 'The recorder could not take records as fast as they came.';
const NO_RECORDS: FlightRecords = { timesMs: [], lengths: [], records: new Uint8Array() };
const NOTHING = { from: 0, to: 0 };
const NO_SPANS: RecordSpans = { small: NOTHING, large: NOTHING };

/**
 * A recorder that copies records into shared memory, and does nothing else for a record: the last minutes stay there, and files
 * are written of it, on another thread. [RC-50]
 */
export class SharedRecorder implements Recorder {
  readonly #context: SharedRecorderContext;
  readonly #flight: FlightRecorder;
  #memory: RecordMemory | undefined = undefined;
  /** Memory as announced to the files. */
  #opened: OpenedMemory | undefined = undefined;
  /** What files have read, or read now. */
  #told = NO_SPANS;
  /** Bytes of records for files since then. */
  #untoldBytes = 0;
  /** Recordings that are started and not in the state yet. */
  #starting = 0;
  #state: FileState = { running: [], targets: 0, listRevision: 0 };
  #cancelRead: Cancel | undefined = undefined;
  #cancelReport: Cancel | undefined = undefined;
  #listener: (state: RecorderState) => void = () => undefined;

  constructor(context: SharedRecorderContext) {
    const { clock, files, limits } = context;
    this.#context = context;
    this.#flight = new FlightRecorder({
      clock,
      maxMarkers: limits.markersPerRecording,
      onDrop: () => this.#report(),
    });
    files.onState((state) => this.#handleState(state));
  }

  add(source: ChannelSource, record: Uint8Array, timeMs: number, targets: number): void {
    const isOfFlight = (targets & FLIGHT_TARGET) !== 0;
    if (isOfFlight && timeMs < this.#flight.earliestMs) this.#startOver();
    const memory = this.#memory ?? this.#useMemory(reserveMemory(this.#bounds));
    memory.add(source, record, timeMs, targets);
    if (isOfFlight) {
      this.#flight.count(timeMs);
      this.#cancelReport ??= this.#context.clock.after(REPORT_MS, () => this.#report());
    }
    if (targets === FLIGHT_TARGET) return;
    this.#untoldBytes += record.length;
    if (this.#untoldBytes > READ_BYTES) this.flush();
    else this.#cancelRead ??= this.#context.clock.after(READ_MS, () => this.flush());
  }

  endTopic(topic: string): void {
    if (this.#flight.settings.isOn) this.#flight.forget(topic);
  }

  addEvent(event: RecordingEvent, targets: number): void {
    if ((targets & FLIGHT_TARGET) !== 0) this.#flight.addEvent(event);
    const ofFiles = targets & ~FLIGHT_TARGET;
    if (ofFiles === 0) return;
    this.flush(); // What waits came before.
    this.#context.files.addEvent(event, ofFiles);
  }

  flush(): void {
    this.#cancelRead?.();
    this.#cancelRead = undefined;
    this.#tellLosses();
    const memory = this.#memory;
    if (memory === undefined || this.#untoldBytes === 0) return;
    this.#untoldBytes = 0;
    const names = this.#tellOfMemory(memory);
    const spans = memory.since(this.#told);
    this.#told = memory.spans;
    void this.#context.files
      .read(spans, names)
      .catch(() => undefined) // The recording that failed reported it.
      .then(() => memory.markRead(spans));
  }

  async start(job: RunningJob): Promise<Recording> {
    this.flush();
    this.#skipUnread();
    this.#starting++;
    this.#memory?.writeFiles(true);
    try {
      return await this.#context.files.start(job);
    } finally {
      this.#starting--;
      if (!this.#isWritingFiles) this.#memory?.writeFiles(false);
    }
  }

  stop(id: string): Promise<Recording> {
    this.flush();
    return this.#context.files.stop(id);
  }

  list(): Promise<RecorderList> {
    return this.#context.files.list();
  }

  get(id: string, page?: RecordingPage): Promise<KeptRecording> {
    this.flush();
    return this.#context.files.get(id, page);
  }

  makerOf(id: string): Promise<string> {
    return this.#context.files.makerOf(id);
  }

  change(id: string, texts: RecordingTexts): Promise<Recording> {
    return this.#context.files.change(id, texts);
  }

  delete(id: string): Promise<void> {
    this.flush();
    return this.#context.files.delete(id);
  }

  async mark(job: MarkerJob): Promise<RecordingMarker> {
    this.flush();
    const marked = await this.#context.files.mark(job, this.#flight.settings.isOn);
    if (job.marker.recordingId === '') this.#flight.mark(job);
    return marked;
  }

  setFlight({ present, ...settings }: FlightJob): Promise<FlightMessage> {
    this.#flight.set(settings, present);
    const { flightBytes } = this.#bounds;
    if (flightBytes === 0) this.#replaceMemory(this.#isWritingFiles);
    else if (flightBytes !== this.#memory?.bounds.flightBytes) this.#resize();
    this.#report();
    return this.flight();
  }

  flight(): Promise<FlightMessage> {
    this.#tellLosses();
    return Promise.resolve(this.#flight.toMessage());
  }

  async find(search: RecordSearch): Promise<FlightRecords> {
    const memory = this.#memory;
    const channels = memory === undefined ? [] : memory.channels.ofTopics(search.topics);
    if (memory === undefined || channels.length === 0) return NO_RECORDS;
    this.#open(memory);
    const sinceMs = Math.max(search.sinceMs, this.#flight.startMs);
    return this.#context.files.find({ ...search, sinceMs, channels, spans: memory.spans });
  }

  keep(job: RecordingJob): Promise<Recording> {
    this.flush();
    const { files } = this.#context;
    if (this.#memory !== undefined) this.#open(this.#memory);
    return files.keep(job, this.#flight.snapshot());
  }

  adopt(job: RecordingJob): Promise<Recording> {
    return this.#context.files.adopt(job);
  }

  onState(listener: (state: RecorderState) => void): void {
    this.#listener = listener;
  }

  async close(): Promise<void> {
    this.flush();
    this.#cancelReport?.();
    this.#flight.close();
    await this.#context.files.close();
  }

  get #isWritingFiles(): boolean {
    return this.#starting > 0 || this.#state.targets !== 0;
  }

  get #bounds(): MemoryBounds {
    const { isOn, maxBytes } = this.#flight.settings;
    return {
      flightBytes: isOn ? maxBytes : 0,
      queueBytes: this.#context.limits.recorderQueueBytes,
    };
  }

  /** What is there already is not recorded by what starts now. */
  #skipUnread(): void {
    const memory = this.#memory;
    if (memory === undefined || this.#isWritingFiles) return;
    this.#told = memory.spans;
    memory.markRead(this.#told);
  }

  #useMemory(memory: RecordMemory): RecordMemory {
    this.#memory = memory;
    this.#told = NO_SPANS;
    this.#flight.use(memory);
    memory.writeFiles(this.#isWritingFiles);
    return memory;
  }

  /** The clock was set back by more than what is held. */
  #startOver(): void {
    this.#flight.clear();
    this.#replaceMemory(true);
  }

  /** Memory of other size, with what fits in. */
  #resize(): void {
    const before = this.#memory;
    if (before === undefined) return;
    this.flush();
    const after = reserveMemory(this.#bounds);
    const channels = before.channels.list();
    const byNumber = new Map(channels.map((channel) => [channel.number, channel]));
    const sources = new Map<number, ChannelSource>();
    const sourceOf = (number: number): ChannelSource => {
      let source = sources.get(number);
      if (source === undefined) {
        const { topic, clientId } = byNumber.get(number)!;
        sources.set(number, (source = { topic, clientId, channel: undefined }));
      }
      return source;
    };
    for (const [{ number }, { timeMs, record }] of before.standing) {
      after.add(sourceOf(number), record, timeMs, FLIGHT_TARGET);
    }
    for (const entry of new SharedReader(before.shared).read(before.spans)) {
      const { channel, record, timeMs, targets } = entry;
      if ((targets & FLIGHT_TARGET) === 0) continue;
      after.add(sourceOf(channel), record, timeMs, FLIGHT_TARGET);
    }
    this.#retire(before);
    this.#useMemory(after);
    this.#told = after.spans;
    after.markRead(this.#told);
  }

  /** Forgets what the memory holds, and has it overwritten. */
  #replaceMemory(isNeeded: boolean): void {
    const before = this.#memory;
    if (before === undefined) return;
    this.flush();
    this.#retire(before);
    if (isNeeded) this.#useMemory(reserveMemory(this.#bounds));
    else {
      this.#memory = undefined;
      this.#flight.use(undefined);
    }
  }

  /** Files read announced memory before it is overwritten. */
  #retire(memory: RecordMemory): void {
    this.#opened = undefined;
    this.#context.files.erase(memory.shared);
  }

  #open(memory: RecordMemory): OpenedMemory {
    const { files } = this.#context;
    const opened = this.#opened;
    if (opened?.memory === memory && opened.generation === files.generation) return opened;
    files.open(memory.shared);
    return (this.#opened = { memory, generation: files.generation, hasNames: false });
  }

  /** @returns channels that the files do not know */
  #tellOfMemory(memory: RecordMemory) {
    const opened = this.#open(memory);
    const untold = memory.channels.takeUntold();
    if (opened.hasNames) return untold;
    opened.hasNames = true;
    return memory.channels.list();
  }

  /** [RC-19] */
  #tellLosses(): void {
    for (const [targets, { fromMs, untilMs, records }] of this.#memory?.takeLosses() ?? []) {
      const gap = gapEvent(fromMs, untilMs, records, TOO_SLOW);
      if ((targets & FLIGHT_TARGET) !== 0) this.#flight.addEvent(gap);
      const ofFiles = targets & ~FLIGHT_TARGET;
      if (ofFiles !== 0) this.#context.files.addEvent(gap, ofFiles);
    }
  }

  #handleState(state: FileState): void {
    this.#state = state;
    if (!this.#isWritingFiles) this.#memory?.writeFiles(false);
    this.#report();
  }

  #report(): void {
    this.#cancelReport?.();
    this.#cancelReport = undefined;
    this.#tellLosses();
    this.#listener({ ...this.#state, flight: this.#flight.toMessage() });
  }
}

/** Less than wanted where the system gives no more: a shorter past is better than none. */
function reserveMemory(bounds: MemoryBounds): RecordMemory {
  try {
    return new RecordMemory(bounds);
  } catch (error) {
    const { flightBytes, queueBytes } = bounds;
    if (!(error instanceof RangeError) || flightBytes + queueBytes < MIN_BYTES) throw error;
    return reserveMemory({ flightBytes: flightBytes / 2, queueBytes: queueBytes / 2 });
  }
}
