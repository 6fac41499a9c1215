import type { UbiiClient } from '@ubii/client-web';
import { unpackFlightRecords } from '@ubii/proto';
import { useLocalStorage } from '@vueuse/core';
import {
  computed,
  inject,
  provide,
  type InjectionKey,
  type Ref,
  type WritableComputedRef,
} from 'vue';
import { subscribeRecords } from '../../connection/live/subscribe-records.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { DEFAULT_LIMITS, readLimits, storedLimits, type HistoryLimits } from './history-limits.ts';
import { PastRecords } from './past-records.ts';
import { FeedScope, TopicFeeds, type FeedPorts, type FeedSource } from './topic-feeds.ts';

const FEEDS: InjectionKey<FeedSource> = Symbol('topic feeds');

/** Limits of histories, stored in this browser. Apply to topics opened afterwards. */
export function useHistoryLimits(): WritableComputedRef<HistoryLimits> {
  const stored = useLocalStorage('ubii.topicHistory', storedLimits(DEFAULT_LIMITS));
  return computed({
    get: () => readLimits(stored.value),
    set: (limits) => (stored.value = storedLimits(limits)),
  });
}

/** One for each connection: all plots ask together. */
const pasts = new WeakMap<UbiiClient, PastRecords>();

function pastOf(client: UbiiClient, clockOffsetMs: Readonly<Ref<number>>): PastRecords {
  const known = pasts.get(client);
  if (known) return known;
  const past = new PastRecords(async (topics) => {
    const found = await client.call('flightRecorderRecords', { topics: [...topics] });
    return Array.from(unpackFlightRecords(found), ({ timeMs, record }) => ({
      timeMs: timeMs - clockOffsetMs.value,
      record,
    }));
  });
  pasts.set(client, past);
  return past;
}

/** Implements the ports with the connection. */
export function useFeedPorts(): FeedPorts {
  const { client, topics } = useConnection();
  const limits = useHistoryLimits();
  return {
    get limits() {
      return limits.value;
    },
    subscribe(topic, onRecord) {
      return subscribeRecords(client, topic, {}, onRecord).close;
    },
    past: (topic) => pastOf(client, topics.clockOffsetMs).of(topic),
    pause: () => new Promise((resolve) => void setTimeout(resolve)),
    publishedMs(topic) {
      const publishedMs = topics.rates.value?.get(topic)?.statistic.publishedMs ?? 0;
      return publishedMs > 0 ? publishedMs - topics.clockOffsetMs.value : undefined;
    },
  };
}

/** Provides feeds for the calling component and its children. */
export function provideTopicFeeds(): TopicFeeds {
  const feeds = new TopicFeeds(useFeedPorts());
  provide(FEEDS, feeds);
  return feeds;
}

/** Provides the feeds of the page for a part of it that may be hidden. */
export function provideFeedScope(): FeedScope {
  const scope = new FeedScope(useTopicFeeds());
  provide(FEEDS, scope);
  return scope;
}

/** Returns the feeds of the page; without one, feeds of the calling component. */
export function useTopicFeeds(): FeedSource {
  return inject(FEEDS, undefined) ?? new TopicFeeds(useFeedPorts());
}
