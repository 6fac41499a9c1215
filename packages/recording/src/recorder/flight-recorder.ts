import type { FlightRecorder as FlightMessage } from '@ubii/proto';
import { FlightRing } from '../flight/flight-ring.ts';
import type { RecordedRecord } from '../records/recorded-record.ts';
import type { RecordingEvent } from '../records/recording-event.ts';
import type { RecordingWriter } from '../writing/recording-writer.ts';
import type { FlightJob, MarkerJob } from './recorder.ts';
import { MarkerList } from './marker-list.ts';

/** Bars of the chart of rates. */
const SLOTS = 60;
const MS_PER_MINUTE = 60_000;
const OFF = { isOn: false, minutes: 0, maxBytes: 0, withImages: false };

/** The last minutes, in memory. [RC-30] */
export class FlightRecorder {
  #settings: Omit<FlightJob, 'present'> = OFF;
  readonly #maxMarkers: number;
  #ring: FlightRing | undefined = undefined;
  #markers: MarkerList;
  /** Records of each slot of time, by the number of the slot since the epoch. */
  readonly #slots = new Map<number, number>();
  #lost = 0;

  constructor(maxMarkers: number) {
    this.#maxMarkers = maxMarkers;
    this.#markers = new MarkerList([], maxMarkers);
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
    } else if (this.#ring === undefined) {
      this.#ring = new FlightRing(limits);
      for (const event of present) this.#ring.addEvent(event);
    } else {
      this.#ring.setLimits(limits);
    }
  }

  addRecord(record: RecordedRecord, timeMs: number): void {
    if (this.#ring === undefined) return;
    this.#ring.addRecord(record);
    const slot = Math.floor(timeMs / this.#slotMs);
    const count = this.#slots.get(slot);
    this.#slots.set(slot, (count ?? 0) + 1);
    if (count === undefined && this.#slots.size > 2 * SLOTS) this.#forgetSlots(slot);
  }

  /** Tells that a topic has no value any more. [RC-33] */
  forget(topic: string): void {
    this.#ring?.forget(topic);
  }

  addEvent(event: RecordingEvent): void {
    if (event.kind === 'gap') this.#lost += event.value.records;
    this.#ring?.addEvent(event);
  }

  /** @throws ServiceError when the marker is refused */
  mark(job: MarkerJob, nowMs: number): void {
    if (this.#ring === undefined) return;
    const sinceMs = nowMs - this.#settings.minutes * MS_PER_MINUTE;
    const held = this.#markers.values().filter(({ timeMs }) => timeMs >= sinceMs);
    this.#markers = new MarkerList(held, this.#maxMarkers);
    this.#ring.addEvent(this.#markers.apply(job));
  }

  /** Writes what is held. [RC-32] */
  async writeTo(writer: RecordingWriter): Promise<void> {
    await this.#ring?.writeTo(writer);
  }

  toMessage(nowMs: number): FlightMessage {
    const { heldMs, heldBytes, records, topics } = this.#ring?.content ?? {
      ...{ heldMs: 0, heldBytes: 0, records: 0, topics: 0 },
    };
    const last = Math.floor(nowMs / this.#slotMs);
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

  #forgetSlots(newest: number): void {
    for (const slot of this.#slots.keys()) {
      if (slot <= newest - SLOTS) this.#slots.delete(slot);
    }
  }
}
