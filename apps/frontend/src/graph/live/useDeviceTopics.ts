import { ComponentIOType } from '@ubii/proto';
import { computed, type ComputedRef } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import type { KnownTopic } from '../model/fit/node-offer.ts';

/** Most topics returned; no list shows more. */
const MAX_TOPICS = 200;

/** A topic that a device has announced. */
export interface DeviceTopic extends KnownTopic {
  /** Name of the component and its client. */
  readonly name: string;
}

/** Announced topics of devices that have no record yet. */
export function useDeviceTopics(): ComputedRef<readonly DeviceTopic[]> {
  const { clients, topics } = useConnection();
  return computed(() => {
    const rates = topics.rates.value;
    const found = new Map<string, DeviceTopic>();
    for (const { name: owner, devices } of clients.list.value ?? []) {
      for (const component of devices.flatMap((device) => device.components)) {
        const { ioType, topic, messageFormat: format } = component;
        const isCounted = (rates?.get(topic)?.statistic.publishedMs ?? 0) > 0;
        if (ioType !== ComponentIOType.PUBLISHER || topic === '' || isCounted) continue;
        const name = component.name || topic.slice(topic.lastIndexOf('/') + 1);
        if (found.size < MAX_TOPICS)
          found.set(topic, { topic, format, name: `${name} · ${owner}` });
      }
    }
    return [...found.values()];
  });
}
