import { compileGlob } from '@ubii/patterns';
import { Re2Patterns } from '@ubii/patterns/re2';
import {
  componentTopic,
  DATA_FORMATS,
  decodeRecord,
  encodeRecord,
  isMasterTopic,
  parseDataFormat,
  type Component,
  type DataFormat,
  type DataFormatValues,
  type EmptyRecord,
  type Init,
  type TopicRecord,
} from '@ubii/proto';
import type { Cancel } from '@ubii/timing';
import type {
  EncodedRecord,
  TopicListener,
  TopicPort,
  TopicSelector,
} from '../ports/topic-port.ts';

const PATTERNS = new Re2Patterns();

interface FakeSubscription {
  readonly selector: TopicSelector;
  readonly listener: TopicListener;
  readonly seen: Set<string>;
}

/** A component the fake knows, with the device it belongs to. */
export interface FakeComponent {
  readonly clientId: string;
  readonly deviceId: string;
  readonly deviceName: string;
  readonly name: string;
  readonly format: DataFormat;
  readonly tags?: readonly string[];
}

/** Topics in memory: retains values, replays them, and matches selectors. */
export class FakeTopics implements TopicPort {
  /** Everything that was published through the port, decoded. */
  readonly published: (TopicRecord | EmptyRecord)[] = [];
  readonly #nodeId: string;
  readonly #records = new Map<string, EncodedRecord>();
  readonly #components = new Map<string, FakeComponent>();
  readonly #subscriptions = new Set<FakeSubscription>();

  /** @param nodeId who publishes through the port */
  constructor(nodeId = 'node-1') {
    this.#nodeId = nodeId;
  }

  get subscriptionCount(): number {
    return this.#subscriptions.size;
  }

  subscribe(selector: TopicSelector, listener: TopicListener): Cancel {
    if (selector.kind === 'regex') PATTERNS.compile(selector.source);
    const subscription = { selector, listener, seen: new Set<string>() };
    this.#subscriptions.add(subscription);
    for (const record of this.#records.values()) this.#deliver(subscription, record);
    return () => void this.#subscriptions.delete(subscription);
  }

  publish(topic: string, record: Uint8Array, valueField: number): string | undefined {
    if (isMasterTopic(topic)) return `only the master publishes on ${topic}`;
    this.published.push(decodeRecord(record));
    this.#put({ topic, bytes: record, valueField, publisherId: this.#nodeId });
    return undefined;
  }

  /** A client publishes. */
  put<F extends DataFormat>(
    topic: string,
    format: F,
    value: Init<DataFormatValues[F]>,
    publisherId = 'client-1',
  ): void {
    const bytes = encodeRecord({ topic, format, value } as Parameters<typeof encodeRecord>[0]);
    this.#put({ topic, bytes, valueField: DATA_FORMATS[format].fieldNumber, publisherId });
  }

  /** A client publishes a record without a value. */
  putEmpty(topic: string, publisherId = 'client-1'): void {
    this.#put({ topic, bytes: encodeRecord({ topic }), valueField: 0, publisherId });
  }

  /** The value of a topic is deleted. */
  delete(topic: string): void {
    if (!this.#records.delete(topic)) return;
    for (const { seen, listener } of this.#subscriptions)
      if (seen.delete(topic)) listener.onGone(topic);
  }

  /** A device's component appears, which publishes. Returns its topic. */
  addComponent(component: FakeComponent): string {
    const topic = componentTopic(component.clientId, component.deviceName, component.name);
    this.#components.set(topic, component);
    return topic;
  }

  #put(record: EncodedRecord): void {
    const deviceId = this.#components.get(record.topic)?.deviceId;
    const known = deviceId === undefined ? record : { ...record, deviceId };
    this.#records.set(record.topic, known);
    for (const subscription of [...this.#subscriptions]) this.#deliver(subscription, known);
  }

  #deliver(subscription: FakeSubscription, record: EncodedRecord): void {
    if (!this.#selects(subscription.selector, record.topic)) return;
    subscription.seen.add(record.topic);
    subscription.listener.onRecord(record);
  }

  #selects(selector: TopicSelector, topic: string): boolean {
    switch (selector.kind) {
      case 'topic':
        return topic === selector.topic;
      case 'regex':
        return PATTERNS.compile(selector.source).test(topic);
      case 'glob':
        return compileGlob(selector.glob)(topic);
      case 'component': {
        const component = this.#components.get(topic);
        return component !== undefined && matches(component, selector.profile);
      }
    }
  }
}

function matches(component: FakeComponent, profile: Component): boolean {
  const format = parseDataFormat(profile.messageFormat);
  return (
    (profile.name === '' || profile.name === component.name) &&
    (profile.deviceId === '' || profile.deviceId === component.deviceId) &&
    (format === undefined || format === component.format) &&
    profile.tags.every((tag) => component.tags?.includes(tag))
  );
}
