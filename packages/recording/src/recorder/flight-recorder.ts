import type { FlightRecorder as FlightMessage } from '@ubii/proto';
import type { Cancel, Clock } from '@ubii/timing';
import { FlightRing } from '../flight/flight-ring.ts';
import type { RecordedRecord } from '../records/recorded-record.ts';
import type { RecordingEvent } from '../records/recording-event.ts';
import type { RecordingWriter } from '../writing/recording-writer.ts';
import type { FlightJob, MarkerJob } from './recorder.ts';
import { MarkerList } from './marker-list.ts';
import { msOf, nsOf } from './nanoseconds.ts';

/** Bars of the chart of rates. */
const SLOTS = 60;
const MS_PER_MINUTE = 60_000;
/** Between two drops of what is over while nothing comes. What is read is exact. */
const MIN_DROP_MS = 1000;
const NS_PER_S = 1_000_000_000n;
const OFF = { isOn: false, minutes: 0, maxBytes: 0, withImages: false };

/** What a flight recorder works with. */
export interface FlightContext {
  readonly clock: Clock;
  readonly maxMarkers: number;
  /** Something that was over left memory while nothing came. */
  readonly onDrop: () => void;
}

/** The last minutes, in memory. [RC-30] */
export class FlightRecorder {
  readonly #context: FlightContext;
  #settings: Omit<FlightJob, 'present'> = OFF;
  #ring: FlightRing | undefined = undefined;
  #markers: MarkerList;
  /** Records of each slot of time, by the number of the slot since the epoch. */
  readonly #slots = new Map<number, number>();
  #lost = 0;
  /** A log time, and what the clocks showed then. Differences of one clock are times that passed, whoever set it. */
  #base = { logTimeNs: 0n, wallMs: 0, monotonicMs: 0 };
  #cancelDrop: Cancel | undefined = undefined;

  constructor(context: FlightContext) {
    this.#context = context;
    this.#markers = new MarkerList([], context.maxMarkers);
  }

  get isOn(): boolean {
    return this.#ring !== undefined;
  }

  get #slotMs(): number {
    return (this.#settings.minutes * MS_PER_MINUTE) / SLOTS;
  }

  /** [RC-31] */
  set({ present, ...settings }: FlightJob): void {
    if (settings.minutes !== this.#settings.minutes) this.#slots.clear();
    this.#settings = settings;
    const { isOn, minutes, maxBytes, withImages } = settings;
    const limits = { maxMs: minutes * MS_PER_MINUTE, maxBytes, withImages };
    if (!isOn) {
      this.#ring = undefined;
      this.#slots.clear();
      this.#markers = new MarkerList([], this.#context.maxMarkers);
      this.close();
    } else if (this.#ring === undefined) {
      this.#ring = new FlightRing(limits);
      this.#setBase(nsOf(this.#context.clock.nowMs()));
      for (const event of present) this.addEvent(event);
    } else {
      this.#ring.setLimits(limits);
      this.close();
      this.#waitForDrop();
    }
  }

  /** Ends the timer. */
  close(): void {
    this.#cancelDrop?.();
    this.#cancelDrop = undefined;
  }

  addRecord(record: RecordedRecord, timeMs: number): void {
    if (this.#ring === undefined) return;
    this.#ring.addRecord(record);
    const { logTimeNs } = record;
    const aheadNs = logTimeNs - this.#base.logTimeNs;
    // Reading clocks for each record would cost more than keeping it.
    if (aheadNs >= NS_PER_S || aheadNs <= -NS_PER_S) this.#setBase(logTimeNs);
    this.#waitForDrop();
    const slot = Math.floor(timeMs / this.#slotMs);
    const count = this.#slots.get(slot);
    this.#slots.set(slot, (count ?? 0) + 1);
    if (count === undefined && this.#slots.size > 2 * SLOTS) this.#forgetSlots(slot);
  }

  /** Tells that a topic has no value any more. [RC-33] */
  forget(topic: string): void {
    this.#pass();
    this.#ring?.forget(topic);
    this.#waitForDrop();
  }

  addEvent(event: RecordingEvent): void {
    if (event.kind === 'gap') this.#lost += event.value.records;
    if (this.#ring === undefined) return;
    this.#pass();
    this.#ring.addEvent(event);
    this.#waitForDrop();
  }

  /** @throws ServiceError when the marker is refused */
  mark(job: MarkerJob): void {
    if (this.#ring === undefined) return;
    this.#pass();
    // Changes of what is over do not count.
    this.#markers = new MarkerList(this.#markers.values(), this.#context.maxMarkers);
    this.addEvent(this.#markers.apply(job));
  }

  /** Writes what is held. [RC-32] */
  async writeTo(writer: RecordingWriter): Promise<void> {
    this.#pass();
    await this.#ring?.writeTo(writer);
  }

  toMessage(): FlightMessage {
    this.#pass();
    const { heldMs, heldBytes, records, topics } = this.#ring?.content ?? {
      ...{ heldMs: 0, heldBytes: 0, records: 0, topics: 0 },
    };
    const last = Math.floor(this.#context.clock.nowMs() / this.#slotMs);
    const recordsPerSecond = this.isOn
      ? Array.from({ length: SLOTS }, (_, index) => {
          const count = this.#slots.get(last - SLOTS + 1 + index) ?? 0;
          return (count * 1000) / this.#slotMs;
        })
      : [];
    return {
      ...this.#settings,
      heldMs,
      heldBytes,
      recordCount: records,
      topicCount: topics,
      recordsPerSecond,
      lostCount: this.#lost,
    };
  }

  /** Log time of now. A clock that was set back, and one that stands still while the machine sleeps, hold nothing up. */
  #nowNs(): bigint {
    const { clock } = this.#context;
    const { logTimeNs, wallMs, monotonicMs } = this.#base;
    const passedMs = Math.max(clock.nowMs() - wallMs, clock.monotonicMs() - monotonicMs, 0);
    return logTimeNs + nsOf(passedMs);
  }

  #setBase(logTimeNs: bigint): void {
    const { clock } = this.#context;
    this.#base = { logTimeNs, wallMs: clock.nowMs(), monotonicMs: clock.monotonicMs() };
  }

  /** Lets what is over leave memory. [RC-35] */
  #pass(): void {
    if (this.#ring === undefined) return;
    const nowNs = this.#nowNs();
    this.#ring.advanceTo(nowNs);
    const sinceMs = msOf(nowNs) - this.#settings.minutes * MS_PER_MINUTE;
    const markers = this.#markers.values();
    const held = markers.filter(({ timeMs }) => timeMs >= sinceMs);
    if (held.length < markers.length)
      this.#markers = new MarkerList(held, this.#context.maxMarkers);
  }

  /** One timer, as long as something held will be over. */
  #waitForDrop(): void {
    if (this.#cancelDrop !== undefined) return;
    const endNs = this.#ring?.nextEndNs;
    if (endNs === undefined) return;
    const delayMs = Math.max(MIN_DROP_MS, Math.ceil(msOf(endNs - this.#nowNs())) + 1);
    this.#cancelDrop = this.#context.clock.after(delayMs, () => {
      this.#cancelDrop = undefined;
      const before = this.#ring?.content.heldBytes;
      this.#pass();
      this.#waitForDrop();
      if (this.#ring?.content.heldBytes !== before) this.#context.onDrop();
    });
  }

  #forgetSlots(newest: number): void {
    for (const slot of this.#slots.keys()) {
      if (slot <= newest - SLOTS) this.#slots.delete(slot);
    }
  }
}
