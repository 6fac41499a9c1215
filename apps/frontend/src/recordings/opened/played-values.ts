import type { TopicRecord } from '@ubii/proto';
import { shallowReactive } from 'vue';
import { formatValue } from '../../topics/values/format-value.ts';
import { decodeRecorded } from '../reading/decode-recorded.ts';
import type { PlayedValue } from '../reading/recording-messages.ts';

/** The value of a topic at the playhead; decoded when it is looked at. */
export class PlayedRecord {
  readonly #value: PlayedValue;
  #record: TopicRecord | undefined;
  #text: string | undefined;
  #isDecoded = false;

  constructor(value: PlayedValue) {
    this.#value = value;
  }

  /** Milliseconds since the beginning of the recording. */
  get timeMs(): number {
    return this.#value.timeMs;
  }

  get sizeBytes(): number {
    return this.#value.record.length;
  }

  /** Undefined when it has no value or cannot be decoded. */
  get record(): TopicRecord | undefined {
    if (!this.#isDecoded) {
      this.#isDecoded = true;
      this.#record = decodeRecorded(this.#value.topic, this.#value.record);
    }
    return this.#record;
  }

  /** The value in one line. */
  get text(): string | undefined {
    const { record } = this;
    return (this.#text ??= record && formatValue(record.format, record.value as never));
  }
}

/** The values of all topics at the playhead, each of them reactive. */
export class PlayedValues {
  readonly #shown = shallowReactive(new Map<string, PlayedRecord>());
  readonly #waiting = new Map<string, PlayedRecord>();
  #isAll = false;

  get(topic: string): PlayedRecord | undefined {
    return this.#shown.get(topic);
  }

  /** @param isAll topics that are not among them have no value */
  add(values: readonly PlayedValue[], isAll: boolean): void {
    if (isAll) {
      this.#waiting.clear();
      this.#isAll = true;
    }
    for (const value of values) this.#waiting.set(value.topic, new PlayedRecord(value));
  }

  /** Shows what came since the last call. */
  show(): void {
    if (this.#isAll)
      for (const topic of this.#shown.keys())
        if (!this.#waiting.has(topic)) this.#shown.delete(topic);
    for (const [topic, record] of this.#waiting) this.#shown.set(topic, record);
    this.#waiting.clear();
    this.#isAll = false;
  }
}
