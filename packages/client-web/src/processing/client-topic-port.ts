import { isMasterTopic } from '@ubii/proto';
import type { TopicListener, TopicPort, TopicSelector } from '@ubii/pm-sandbox';
import type { TopicPattern } from '../core/topic-pattern.ts';
import type { UbiiClient } from '../core/ubii-client.ts';
import type { DeviceTopics } from './device-topics.ts';

/** What the port needs of a client. */
export type TopicClient = Pick<UbiiClient, 'subscribeEncoded' | 'publishEncoded'>;

/** The topics of the master, as the modules of a node see them: over the node's client. */
export class ClientTopicPort implements TopicPort {
  readonly #client: TopicClient;
  readonly #devices: DeviceTopics;

  constructor(client: TopicClient, devices: DeviceTopics) {
    this.#client = client;
    this.#devices = devices;
  }

  subscribe(selector: TopicSelector, listener: TopicListener): () => void {
    const isForMany = selector.kind !== 'topic';
    if (isForMany) this.#devices.watch();
    const cancel = this.#client.subscribeEncoded(patternOf(selector), {
      onRecord: (record) => {
        const deviceId = isForMany ? this.#devices.deviceOf(record.topic) : undefined;
        listener.onRecord(deviceId === undefined ? record : { ...record, deviceId });
      },
      onGone: (topic) => listener.onGone(topic),
    });
    let isCancelled = false;
    return () => {
      if (isCancelled) return;
      isCancelled = true;
      cancel();
      if (isForMany) this.#devices.unwatch();
    };
  }

  publish(topic: string, record: Uint8Array, valueField: number): string | undefined {
    if (topic === '') return 'An output needs a topic to be published on';
    if (isMasterTopic(topic)) return `Only the master may publish on "${topic}"`;
    this.#client.publishEncoded(topic, record, valueField);
    return undefined;
  }
}

function patternOf(selector: TopicSelector): TopicPattern {
  switch (selector.kind) {
    case 'topic':
      return { topic: selector.topic };
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
