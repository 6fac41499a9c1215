import { encode, timestampFromMs, type Init, type TopicDataRecord } from '@ubii/proto';
import { recordValueField } from '@ubii/proto/wire';
import type { Clock } from '../ports/clock.ts';
import { Publication } from '../topics/publication.ts';
import { publish, type PublishContext } from '../topics/publisher.ts';

/** Publishes what the master has to say itself. */
export class MasterPublisher {
  readonly #context: PublishContext;
  readonly #clock: Clock;
  readonly #publication = new Publication();

  constructor(context: PublishContext, clock: Clock) {
    this.#context = context;
    this.#clock = clock;
  }

  /** Publishes this value on a topic of the master. */
  publish(topic: string, value: Init<Omit<TopicDataRecord, 'topic' | 'timestamp'>>): void {
    const nowMs = this.#clock.nowMs();
    const record = encode('ubii.topicData.TopicDataRecord', {
      topic,
      timestamp: timestampFromMs(nowMs),
      ...value,
    });
    const publication = this.#publication;
    publication.topic = topic;
    publication.frame = record;
    publication.end = record.byteLength;
    publication.valueField = recordValueField(record);
    publication.nowMs = nowMs;
    publication.monotonicMs = this.#clock.monotonicMs();
    publish(this.#context, publication);
  }

  /** Deletes the value of a topic of the master. */
  deleteValue(topic: string): void {
    const entry = this.#context.topics.get(topic);
    if (entry !== undefined) this.#context.topics.deleteValue(entry);
  }
}
