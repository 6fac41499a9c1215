import { DATA_FORMATS, dataFormatOfField, isMasterTopic } from '@ubii/proto';
import { encodeNodeMessageFrame } from '@ubii/proto/wire';
import type { TopicListener, TopicPort, TopicSelector } from '@ubii/pm-sandbox';
import type { EncodedListener, EncodedRecord } from '../core/subscriptions/encoded-record.ts';
import type { TopicPattern } from '../core/subscriptions/topic-pattern.ts';
import type { UbiiClient } from '../core/client/ubii-client.ts';
import type { DeviceTopics } from './device-topics.ts';

/** Dependencies of the port on a client. */
export type TopicClient = Pick<
  UbiiClient,
  'subscribeEncoded' | 'publishEncoded' | 'sendNodeMessage'
>;

/** The topics of the master, as the modules of a node see them: over the node's client. */
export class ClientTopicPort implements TopicPort {
  readonly #client: TopicClient;
  readonly #devices: DeviceTopics;

  constructor(client: TopicClient, devices: DeviceTopics) {
    this.#client = client;
    this.#devices = devices;
  }

  subscribe(selector: TopicSelector, listener: TopicListener): () => void {
    if (selector.kind === 'topic') return this.#client.subscribeEncoded(selector.topic, listener);
    this.#devices.watch();
    const pattern = patternOf(selector);
    const withDevices = new WithDevices(listener, this.#devices);
    const cancel = this.#client.subscribeEncoded(pattern, withDevices);
    let isCancelled = false;
    return () => {
      if (isCancelled) return;
      isCancelled = true;
      cancel();
      withDevices.close();
      this.#devices.unwatch();
    };
  }

  publish(topic: string, record: Uint8Array, valueField: number): string | undefined {
    if (topic === '') return 'An output needs a topic to be published on';
    if (isMasterTopic(topic)) return `Only the master may publish on "${topic}"`;
    this.#client.publishEncoded(topic, record, valueField);
    return undefined;
  }

  /** [SE-63] */
  endTopics(topics: readonly string[]): void {
    this.#client.sendNodeMessage(encodeNodeMessageFrame({ endedTopics: { topics: [...topics] } }));
  }
}

/** A record that waits until devices are known. */
interface HeldRecord {
  readonly topic: string;
  /** A newer one does not replace it. */
  readonly isEvent: boolean;
  readonly tell: () => void;
}

/** Records that wait for an answer; more are let go, oldest first. */
const MAX_HELD_RECORDS = 4096;

/** Adds the device to each record. What comes while devices are being asked for waits for the answer. */
class WithDevices implements EncodedListener {
  readonly #listener: TopicListener;
  readonly #devices: DeviceTopics;
  #held: HeldRecord[] | undefined;
  #isClosed = false;

  constructor(listener: TopicListener, devices: DeviceTopics) {
    this.#listener = listener;
    this.#devices = devices;
  }

  onRecord(record: EncodedRecord): void {
    const { topic, valueField } = record;
    const format = dataFormatOfField(valueField);
    const isEvent = format !== undefined && DATA_FORMATS[format].isEvent;
    this.#inOrder({
      topic,
      isEvent,
      tell: () => {
        const deviceId = this.#devices.deviceOf(topic);
        this.#listener.onRecord(deviceId === undefined ? record : { ...record, deviceId });
      },
    });
  }

  onGone(topic: string): void {
    this.#inOrder({ topic, isEvent: true, tell: () => this.#listener.onGone(topic) });
  }

  /** Discard the waiting calls. */
  close(): void {
    this.#isClosed = true;
  }

  #inOrder(next: HeldRecord): void {
    if (this.#held !== undefined) {
      // Of a state the newest counts: pictures must not queue up behind a slow answer.
      const last = next.isEvent
        ? -1
        : this.#held.findLastIndex(({ topic }) => topic === next.topic);
      if (last >= 0 && !this.#held[last]!.isEvent) this.#held.splice(last, 1);
      this.#held.push(next);
      if (this.#held.length > MAX_HELD_RECORDS) this.#held.shift();
      return;
    }
    const { reading } = this.#devices;
    if (reading === undefined) return next.tell();
    this.#held = [next];
    void reading.then(() => {
      const held = this.#held ?? [];
      this.#held = undefined;
      for (const { tell } of held) if (!this.#isClosed) tell();
    });
  }
}

function patternOf(selector: Exclude<TopicSelector, { kind: 'topic' }>): TopicPattern {
  switch (selector.kind) {
    case 'glob':
      return { glob: selector.glob };
    case 'regex':
      return { regex: selector.source };
    case 'component': {
      const { id, name, messageFormat, deviceId, tags } = selector.profile;
      return { component: { id, name, format: messageFormat, deviceId, tags } };
    }
  }
}
