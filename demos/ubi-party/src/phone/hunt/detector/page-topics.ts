import type { EncodedRecord, TopicListener, TopicPort, TopicSelector } from '@ubii/pm-sandbox';
import { DATA_FORMATS, encodeRecord, type Image2D } from '@ubii/proto';

/** Topics inside of this page: pictures go to the module, and what it finds comes back. Nothing of it leaves. */
export class PageTopics implements TopicPort {
  readonly #listeners = new Map<string, TopicListener>();
  readonly #handleOutput: (topic: string, record: Uint8Array) => void;

  constructor(handleOutput: (topic: string, record: Uint8Array) => void) {
    this.#handleOutput = handleOutput;
  }

  subscribe(selector: TopicSelector, listener: TopicListener): () => void {
    if (selector.kind !== 'topic') throw new Error('This page has no patterns of topics.');
    this.#listeners.set(selector.topic, listener);
    return () => void this.#listeners.delete(selector.topic);
  }

  publish(topic: string, record: Uint8Array): undefined {
    this.#handleOutput(topic, record);
  }

  put(topic: string, value: Image2D): void {
    const record: EncodedRecord = {
      topic,
      bytes: encodeRecord({ topic, format: 'image2D', value }),
      valueField: DATA_FORMATS.image2D.fieldNumber,
      publisherId: '',
      isOwned: true,
    };
    this.#listeners.get(topic)?.onRecord(record);
  }
}
