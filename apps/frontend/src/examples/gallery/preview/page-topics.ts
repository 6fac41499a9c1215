import type { PatternCompiler } from '@ubii/patterns';
import type { TopicListener, TopicPort, TopicSelector } from '@ubii/pm-sandbox';
import { decodeRecord, encodeRecord, type RecordInit, type TopicRecord } from '@ubii/proto';
import type { Cancel } from '@ubii/timing';
import { TryTopics } from '../../../modules/cases/try-topics.ts';

const PAGE = 'this-page';

/** The topics of one preview: records of its modules reach only its other modules. */
export class PageTopics implements TopicPort {
  readonly #topics: TryTopics;
  readonly #onRecord: (record: TopicRecord) => void;

  constructor(patterns: PatternCompiler, onRecord: (record: TopicRecord) => void) {
    this.#topics = new TryTopics(patterns);
    this.#onRecord = onRecord;
  }

  subscribe(selector: TopicSelector, listener: TopicListener): Cancel {
    return this.#topics.subscribe(selector, listener);
  }

  publish(topic: string, bytes: Uint8Array): undefined {
    const record = decodeRecord(bytes);
    if (record.format !== undefined) this.#onRecord(record);
    this.#topics.put(topic, bytes, PAGE);
  }

  /** Publishes a record from outside the session. */
  put(record: RecordInit): void {
    this.publish(record.topic, encodeRecord(record));
  }
}
