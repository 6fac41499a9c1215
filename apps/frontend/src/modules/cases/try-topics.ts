import { compileGlob, type PatternCompiler } from '@ubii/patterns';
import { recordValueField } from '@ubii/proto/wire';
import type { EncodedRecord, TopicListener, TopicPort, TopicSelector } from '@ubii/pm-sandbox';
import type { Cancel } from '@ubii/timing';

interface Subscription {
  readonly selects: (topic: string) => boolean;
  readonly listener: TopicListener;
}

function matcher(selector: TopicSelector, patterns: PatternCompiler): (topic: string) => boolean {
  switch (selector.kind) {
    case 'topic':
      return (topic) => topic === selector.topic;
    case 'glob':
      return compileGlob(selector.glob);
    case 'regex':
      return patterns.compile(selector.source).test;
    case 'component':
      return () => false;
  }
}

/** Topics of the try-out, in this page only; nothing is sent to the master. */
export class TryTopics implements TopicPort {
  readonly #records = new Map<string, EncodedRecord>();
  readonly #subscriptions = new Set<Subscription>();
  readonly #patterns: PatternCompiler;
  readonly #onOutput: (topic: string, bytes: Uint8Array) => void;

  /** @param onOutput gets what the module publishes; without it that is observed at the sandbox */
  constructor(
    patterns: PatternCompiler,
    onOutput: (topic: string, bytes: Uint8Array) => void = () => undefined,
  ) {
    this.#patterns = patterns;
    this.#onOutput = onOutput;
  }

  subscribe(selector: TopicSelector, listener: TopicListener): Cancel {
    const subscription = { selects: matcher(selector, this.#patterns), listener };
    this.#subscriptions.add(subscription);
    for (const [topic, record] of this.#records) {
      if (subscription.selects(topic)) listener.onRecord(record);
    }
    return () => void this.#subscriptions.delete(subscription);
  }

  publish(topic: string, bytes: Uint8Array): undefined {
    this.#onOutput(topic, bytes);
  }

  put(topic: string, bytes: Uint8Array, publisherId: string): void {
    const record = { topic, bytes, publisherId, valueField: recordValueField(bytes) };
    this.#records.set(topic, record);
    for (const { selects, listener } of [...this.#subscriptions]) {
      if (selects(topic)) listener.onRecord(record);
    }
  }

  /** Removes the values of topics that are not among these. */
  keepOnly(topics: ReadonlySet<string>): void {
    for (const topic of [...this.#records.keys()]) {
      if (topics.has(topic) || !this.#records.delete(topic)) continue;
      for (const { selects, listener } of this.#subscriptions) {
        if (selects(topic)) listener.onGone(topic);
      }
    }
  }
}
