import type { FlightRecorder as FlightMessage, FlightRecorderSettings } from '@ubii/proto';
import type { Cancel, Clock } from '@ubii/timing';
import type { NamedChannel } from '../arena/channels.ts';
import type { RecordMemory } from '../arena/record-memory.ts';
import type { RecordSpans } from '../arena/shared-records.ts';
import { MarkerList } from './marker-list.ts';
import { msOf, nsOf } from '../records/recorded-record.ts';
import type { MarkerJob } from './recorder.ts';
import type { RecordingEvent } from '../records/recording-event.ts';
import { HeldEvents } from './held-events.ts';

/** Bars of the chart of rates. */
const SLOTS = 60;
const MS_PER_MINUTE = 60_000;
/** Between two drops of what is over while nothing comes. What is read is exact. */
const MIN_DROP_MS = 1000;
/** Between two drops when there is more: other work comes first. */
const NEXT_DROP_MS = 5;
/** Clocks are read again when records are further apart. */
const BASE_MS = 1000;
/** Share of the memory for events: an eighth. */
const SHARE = 8;
const OFF: FlightRecorderSettings = { isOn: false, minutes: 0, maxBytes: 0, withImages: false };

/** What a flight recorder works with. */
export interface FlightContext {
  readonly clock: Clock;
  readonly maxMarkers: number;
  /** Something that was over left memory while nothing came. */
  readonly onDrop: () => void;
}

/** What the flight recorder holds at a moment, to be written by another thread. */
export interface FlightSnapshot {
  /** Where the records are, in memory that both threads have. */
  readonly spans: RecordSpans;
  /** How many there are: fewer are read when some are overwritten meanwhile. */
  readonly records: number;
  /** When the time begins that is kept, epoch milliseconds. */
  readonly startMs: number;
  readonly channels: readonly NamedChannel[];
  /** Values that stood before the first record of their channel. */
  readonly standing: readonly FlightValue[];
  readonly events: readonly RecordingEvent[];
}

/** A value that stood, with the number of its channel. */
export interface FlightValue {
  readonly channel: number;
  readonly timeMs: number;
  readonly record: Uint8Array<ArrayBuffer>;
}

/** The last minutes, in memory. [RC-30] */
export class FlightRecorder {
  readonly #context: FlightContext;
  #settings = OFF;
  #memory: RecordMemory | undefined = undefined;
  #events = new HeldEvents();
  #markers: MarkerList;
  /** Records of each slot of time, by the number of the slot since the epoch. */
  readonly #slots = new Map<number, { count: number }>();
  #slot = { fromMs: 0, untilMs: 0, count: 0 };
  #lost = 0;
  #newestMs = -Infinity;
  /** Time of a record, and what the clocks showed then. Differences of one clock are times that passed, whoever set it. */
  #base = { timeMs: 0, wallMs: 0, monotonicMs: 0 };
  #cancelDrop: Cancel | undefined = undefined;

  constructor(context: FlightContext) {
    this.#context = context;
    this.#markers = new MarkerList([], context.maxMarkers);
  }

  get settings(): FlightRecorderSettings {
    return this.#settings;
  }

  /** Records before this moment come of a clock that was set back: what is held would stand in the future for hours. */
  get earliestMs(): number {
    return this.#newestMs - this.#lengthMs;
  }

  /** [RC-31] */
  set(settings: FlightRecorderSettings, present: readonly RecordingEvent[]): void {
    const wasOn = this.#settings.isOn;
    if (settings.minutes !== this.#settings.minutes) this.#forgetRates();
    this.#settings = settings;
    this.close();
    if (!settings.isOn) return this.clear();
    if (wasOn) return this.#waitForDrop();
    this.#setBase(this.#context.clock.nowMs());
    for (const event of present) this.addEvent(event);
  }

  /** @param memory with its records; undefined before the first one */
  use(memory: RecordMemory | undefined): void {
    this.#memory = memory;
    this.#reserve();
  }

  /** Forgets all but the memory. */
  clear(): void {
    this.#forgetRates();
    this.#markers = new MarkerList([], this.#context.maxMarkers);
    this.#events = new HeldEvents();
    this.#newestMs = -Infinity;
    this.#reserve();
    this.close();
  }

  /** Ends the timer. */
  close(): void {
    this.#cancelDrop?.();
    this.#cancelDrop = undefined;
  }

  /** A record came into the memory. */
  count(timeMs: number): void {
    if (timeMs > this.#newestMs) this.#newestMs = timeMs;
    // Reading clocks for each record would cost more than keeping it.
    const aheadMs = timeMs - this.#base.timeMs;
    if (aheadMs >= BASE_MS || aheadMs <= -BASE_MS) this.#setBase(timeMs);
    if (timeMs < this.#slot.fromMs || timeMs >= this.#slot.untilMs) this.#openSlot(timeMs);
    this.#slot.count++;
    if (this.#cancelDrop === undefined) this.#waitForDrop();
  }

  /** Records that a topic has no value any more. [RC-33] */
  forget(topic: string): void {
    this.#pass();
    this.#memory?.endTopic(topic, this.#presentMs);
    this.#waitForDrop();
  }

  addEvent(event: RecordingEvent): void {
    if (event.kind === 'gap') this.#lost += event.value.records;
    if (!this.#settings.isOn) return;
    this.#pass();
    // A marker may stand for a moment to come; it leaves as one of now.
    const nowNs = nsOf(this.#presentMs);
    this.#events.add(event, event.timeNs < nowNs ? event.timeNs : nowNs);
    this.#events.limit(this.#settings.maxBytes / SHARE);
    this.#reserve();
    this.#waitForDrop();
  }

  /** @throws ServiceError when the marker is refused */
  mark(job: MarkerJob): void {
    if (!this.#settings.isOn) return;
    this.#pass();
    // Changes of what is over do not count.
    this.#markers = new MarkerList(this.#markers.values(), this.#context.maxMarkers);
    this.addEvent(this.#markers.apply(job));
  }

  /** What is held now, to be written. [RC-32] */
  snapshot(): FlightSnapshot {
    this.#pass();
    const memory = this.#memory;
    const standing = [...(memory?.standing ?? [])].map(([{ number }, value]) => ({
      ...value,
      channel: number,
    }));
    const none = { from: 0, to: 0 };
    return {
      spans: memory?.spans ?? { small: none, large: none },
      records: memory?.records ?? 0,
      startMs: this.#startMs(),
      channels: memory?.channels.list() ?? [],
      standing,
      events: [...this.#events],
    };
  }

  /** When the time begins that is held, epoch milliseconds. [RC-35] */
  get startMs(): number {
    this.#pass();
    return this.#startMs();
  }

  toMessage(): FlightMessage {
    this.#pass();
    const memory = this.#memory;
    const isEmpty = memory?.oldestMs === undefined;
    return {
      ...this.#settings,
      heldMs: isEmpty ? 0 : Math.max(0, this.#newestMs - this.#startMs()),
      heldBytes: (memory?.heldBytes ?? 0) + this.#events.bytes,
      recordCount: memory?.records ?? 0,
      topicCount: memory?.channels.topicCount ?? 0,
      recordsPerSecond: this.#rates(),
      lostCount: this.#lost,
    };
  }

  get #lengthMs(): number {
    return this.#settings.minutes * MS_PER_MINUTE;
  }

  get #slotMs(): number {
    return this.#lengthMs / SLOTS;
  }

  /** Time of now. A clock that was set back, and one that stands still while the machine sleeps, hold nothing up. */
  get #nowMs(): number {
    const { clock } = this.#context;
    const { timeMs, wallMs, monotonicMs } = this.#base;
    return timeMs + Math.max(clock.nowMs() - wallMs, clock.monotonicMs() - monotonicMs, 0);
  }

  get #presentMs(): number {
    return Math.max(this.#nowMs, this.#newestMs);
  }

  /** When the time begins that is held. */
  #startMs(): number {
    const oldestMs = this.#memory?.oldestMs ?? this.#newestMs;
    return Math.max(oldestMs, this.#presentMs - this.#lengthMs);
  }

  #setBase(timeMs: number): void {
    const { clock } = this.#context;
    this.#base = { timeMs, wallMs: clock.nowMs(), monotonicMs: clock.monotonicMs() };
  }

  /** Lets what is over leave memory. @returns whether there is more [RC-35] */
  #pass(): boolean {
    if (!this.#settings.isOn) return false;
    const sinceMs = this.#presentMs - this.#lengthMs;
    const isMore = this.#memory?.expire(sinceMs) ?? false;
    this.#events.expire(nsOf(sinceMs));
    this.#reserve();
    const markers = this.#markers.values();
    const held = markers.filter(({ timeMs }) => timeMs >= sinceMs);
    if (held.length < markers.length)
      this.#markers = new MarkerList(held, this.#context.maxMarkers);
    return isMore;
  }

  #reserve(): void {
    this.#memory?.reserve(this.#events.bytes);
  }

  /** One timer, as long as something held will be over. */
  #waitForDrop(isMore = false): void {
    if (this.#cancelDrop !== undefined) return;
    const oldestMs = this.#oldestMs();
    if (oldestMs === undefined) return;
    const dueMs = Math.ceil(oldestMs + this.#lengthMs - this.#nowMs) + 1;
    const delayMs = isMore ? NEXT_DROP_MS : Math.max(MIN_DROP_MS, dueMs);
    this.#cancelDrop = this.#context.clock.after(delayMs, () => {
      this.#cancelDrop = undefined;
      const before = this.#heldBytes();
      this.#waitForDrop(this.#pass());
      if (this.#heldBytes() !== before) this.#context.onDrop();
    });
  }

  #heldBytes(): number {
    return (this.#memory?.heldBytes ?? 0) + this.#events.bytes;
  }

  /** Of records and events; undefined when only standing values and states are held. */
  #oldestMs(): number | undefined {
    const recordMs = this.#memory?.oldestMs;
    const eventNs = this.#events.oldestNs;
    if (eventNs === undefined) return recordMs;
    return Math.min(recordMs ?? Infinity, msOf(eventNs));
  }

  #openSlot(timeMs: number): void {
    const number = Math.floor(timeMs / this.#slotMs);
    const known = this.#slots.get(number);
    this.#slot = {
      fromMs: number * this.#slotMs,
      untilMs: (number + 1) * this.#slotMs,
      count: known?.count ?? 0,
    };
    this.#slots.set(number, this.#slot);
    if (this.#slots.size <= 2 * SLOTS) return;
    for (const slot of this.#slots.keys()) if (slot <= number - SLOTS) this.#slots.delete(slot);
  }

  #forgetRates(): void {
    this.#slots.clear();
    this.#slot = { fromMs: 0, untilMs: 0, count: 0 };
  }

  #rates(): number[] {
    if (!this.#settings.isOn) return [];
    const last = Math.floor(this.#context.clock.nowMs() / this.#slotMs);
    return Array.from({ length: SLOTS }, (_, index) => {
      const count = this.#slots.get(last - SLOTS + 1 + index)?.count ?? 0;
      return (count * 1000) / this.#slotMs;
    });
  }
}
