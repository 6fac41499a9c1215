import { encode, timestampFromMs, type Init, type TopicDataRecord } from '@ubii/proto';
import { recordValueField } from '@ubii/proto/wire';
import type { Clock } from '@ubii/timing';
import { areEqual } from '../topics/equal-bytes.ts';
import { Publication } from '../topics/publication.ts';
import { publish, type PublishContext } from '../topics/publisher.ts';

/** The value of a record. */
type Value = Init<Omit<TopicDataRecord, 'topic' | 'timestamp'>>;

/** Publishes what the master has to say itself. */
export class MasterPublisher {
  readonly #context: PublishContext;
  readonly #clock: Clock;
  readonly #publication = new Publication();

  constructor(context: PublishContext, clock: Clock) {
    this.#context = context;
    this.#clock = clock;
  }

  /** Publishes this value on a topic of the master. Returns the bytes of its record. */
  publish(topic: string, value: Value): number {
    const nowMs = this.#clock.nowMs();
    const record = recordOf(topic, nowMs, value);
    const publication = this.#publication;
    publication.topic = topic;
    publication.frame = record;
    publication.end = record.byteLength;
    publication.valueField = recordValueField(record);
    publication.nowMs = nowMs;
    publication.monotonicMs = this.#clock.monotonicMs();
    publish(this.#context, publication);
    return record.byteLength;
  }

  /** The same of a state, unless it is what the topic says already: then 0. */
  publishChange(topic: string, value: Value): number {
    const entry = this.#context.topics.get(topic);
    if (entry?.record !== undefined) {
      const same = recordOf(topic, entry.publishedMs, value);
      if (areEqual(same, entry.record)) return 0;
    }
    return this.publish(topic, value);
  }

  /** Deletes the value of a topic of the master. */
  deleteValue(topic: string): void {
    const entry = this.#context.topics.get(topic);
    if (entry !== undefined) this.#context.topics.deleteValue(entry);
  }
}

function recordOf(topic: string, timeMs: number, value: Value): Uint8Array {
  return encode('ubii.topicData.TopicDataRecord', {
    topic,
    timestamp: timestampFromMs(timeMs),
    ...value,
  });
}
