import { compileGlob, type PatternCompiler } from '@ubii/patterns';
import type { Component } from '@ubii/proto';
import { recordValueField } from '@ubii/proto/wire';
import type { EncodedRecord, TopicListener, TopicPort, TopicSelector } from '@ubii/pm-sandbox';
import type { Cancel } from '@ubii/timing';

interface Subscription {
  readonly selects: (topic: string) => boolean;
  readonly listener: TopicListener;
}

/** What is known about the topics of a try-out. */
export interface TryTopicsOptions {
  /** Gets what the module publishes; without it that is observed at the sandbox. */
  readonly onOutput?: (topic: string, bytes: Uint8Array) => void;
  /** Topics of the components that match a profile. @default there are no components */
  readonly topicsOf?: (profile: Component) => readonly string[];
  /** Id of the device that has the component of a topic. */
  readonly deviceOf?: (topic: string) => string | undefined;
}

function matcher(
  selector: TopicSelector,
  patterns: PatternCompiler,
  topicsOf: TryTopicsOptions['topicsOf'],
): (topic: string) => boolean {
  switch (selector.kind) {
    case 'topic':
      return (topic) => topic === selector.topic;
    case 'glob':
      return compileGlob(selector.glob);
    case 'regex':
      return patterns.compile(selector.source).test;
    case 'component': {
      const topics = new Set(topicsOf?.(selector.profile));
      return (topic) => topics.has(topic);
    }
  }
}

/** Topics of the try-out, in this page only; nothing is sent to the master. */
export class TryTopics implements TopicPort {
  readonly #records = new Map<string, EncodedRecord>();
  readonly #subscriptions = new Set<Subscription>();
  readonly #patterns: PatternCompiler;
  readonly #options: TryTopicsOptions;

  constructor(patterns: PatternCompiler, options: TryTopicsOptions = {}) {
    this.#patterns = patterns;
    this.#options = options;
  }

  subscribe(selector: TopicSelector, listener: TopicListener): Cancel {
    const selects = matcher(selector, this.#patterns, this.#options.topicsOf);
    const subscription = { selects, listener };
    this.#subscriptions.add(subscription);
    for (const [topic, record] of this.#records) {
      if (subscription.selects(topic)) listener.onRecord(record);
    }
    return () => void this.#subscriptions.delete(subscription);
  }

  publish(topic: string, bytes: Uint8Array): undefined {
    this.#options.onOutput?.(topic, bytes);
  }

  put(topic: string, bytes: Uint8Array, publisherId: string): void {
    const deviceId = this.#options.deviceOf?.(topic) ?? '';
    const record = { topic, bytes, publisherId, deviceId, valueField: recordValueField(bytes) };
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
