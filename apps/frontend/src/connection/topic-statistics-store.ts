import { ConnectionError, type UbiiClient } from '@ubii/client-web';
import { ServiceError } from '@ubii/proto';
import { computed, shallowRef, triggerRef, type Ref, type ShallowRef } from 'vue';
import { createInterest } from './interest.ts';
import { usePoll } from './poll.ts';
import { TopicRates, type TopicRate } from './topic-rates.ts';

/** Rates of all topics, from the master's counters; asked for only while someone looks. */
export interface TopicStatisticsStore {
  /**
   * By topic. One map for the life of the page, changed in place and triggered after each reply;
   * `undefined` before the first.
   */
  readonly rates: Readonly<ShallowRef<ReadonlyMap<string, TopicRate> | undefined>>;
  /** The master's clock minus this machine's, milliseconds, as of the newest reply. */
  readonly clockOffsetMs: Readonly<ShallowRef<number>>;
  /** True when this is an original master, which has no such service. */
  readonly isUnsupported: Readonly<ShallowRef<boolean>>;
  /** Wants rates this often while the calling component lives, milliseconds. */
  watch(intervalMs: number): void;
}

export function createTopicStatisticsStore(
  client: UbiiClient,
  isConnected: Ref<boolean>,
  nowMs: () => number,
): TopicStatisticsStore {
  const topicRates = new TopicRates();
  const rates = shallowRef<ReadonlyMap<string, TopicRate>>();
  const clockOffsetMs = shallowRef(0);
  const isUnsupported = shallowRef(false);
  const interest = createInterest();

  async function ask(): Promise<void> {
    try {
      const reply = await client.call('topicStatistics', { cursor: topicRates.cursor });
      topicRates.apply(reply);
      clockOffsetMs.value = reply.masterTimeMs - nowMs();
      isUnsupported.value = false;
      rates.value = topicRates.rates;
      triggerRef(rates);
    } catch (cause) {
      if (cause instanceof ConnectionError) return;
      if (!(cause instanceof ServiceError)) throw cause;
      isUnsupported.value = cause.code === 'unimplemented' || cause.code === 'not_found';
    }
  }

  usePoll(
    ask,
    () => interest.intervalMs.value ?? 0,
    computed(() => isConnected.value && interest.intervalMs.value !== undefined),
  );

  return {
    rates,
    clockOffsetMs,
    isUnsupported,
    watch: (intervalMs) => interest.express(intervalMs),
  };
}
