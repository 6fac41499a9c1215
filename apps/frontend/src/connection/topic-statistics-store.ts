import { ConnectionError, type UbiiClient } from '@ubii/client-web';
import type { ServiceError } from '@ubii/proto';
import { tryOnScopeDispose } from '@vueuse/core';
import {
  computed,
  shallowRef,
  triggerRef,
  watch,
  type ComputedRef,
  type Ref,
  type ShallowRef,
} from 'vue';
import { measureClock, type ClockOffset } from './clock-offset.ts';
import { createInterest } from './interest.ts';
import { usePoll } from './poll.ts';
import { TopicRates, type TopicChanges, type TopicRate } from './topic-rates.ts';
import { tryRequest, type RequestError } from './useAttempt.ts';

/** Rates of all topics, from the master's statistics; requested only while there are viewers. */
export interface TopicStatisticsStore {
  /**
   * By topic. The same map for the life of the page, mutated in place and triggered after each reply; `undefined`
   * before the first.
   */
  readonly rates: Readonly<ShallowRef<ReadonlyMap<string, TopicRate> | undefined>>;
  /** Time of the newest reply, epoch milliseconds of the master's clock; 0 before. */
  readonly masterTimeMs: Readonly<ShallowRef<number>>;
  /** The master's clock minus this computer's, to compute the age of values, milliseconds; 0 before the first reply. */
  readonly clockOffsetMs: ComputedRef<number>;
  /** True for an original master, which does not have the service. */
  readonly isUnsupported: Readonly<ShallowRef<boolean>>;
  /** Error of the last request, when the master refused it. */
  readonly error: Readonly<ShallowRef<ServiceError | undefined>>;
  /** Requests rates at this interval while the calling component or scope is active, milliseconds. */
  watch(intervalMs: number): void;
  /** Calls `fn` with added and removed topics, before `rates` is triggered, while the calling scope is active. */
  onChanges(fn: (changes: TopicChanges) => void): void;
}

export function createTopicStatisticsStore(
  client: UbiiClient,
  isConnected: Ref<boolean>,
  nowMs: () => number,
): TopicStatisticsStore {
  const topicRates = new TopicRates();
  const rates = shallowRef<ReadonlyMap<string, TopicRate>>();
  const masterTimeMs = shallowRef(0);
  const clock = shallowRef<ClockOffset>();
  const isUnsupported = shallowRef(false);
  const error = shallowRef<ServiceError>();
  const listeners = new Set<(changes: TopicChanges) => void>();
  const interest = createInterest();

  async function ask(): Promise<void> {
    const sentMs = nowMs();
    const reply = await tryRequest(
      () => client.call('topicStatistics', { cursor: topicRates.cursor }),
      handleError,
    );
    if (reply === undefined) return;
    const changes = topicRates.apply(reply);
    for (const listener of listeners) listener(changes);
    masterTimeMs.value = reply.masterTimeMs;
    clock.value = measureClock(
      reply.reset ? undefined : clock.value,
      sentMs,
      nowMs(),
      reply.masterTimeMs,
    );
    isUnsupported.value = false;
    error.value = undefined;
    rates.value = topicRates.rates;
    triggerRef(rates);
  }
  function handleError(cause: RequestError): void {
    if (cause instanceof ConnectionError) return;
    isUnsupported.value = cause.code === 'unimplemented' || cause.code === 'not_found';
    error.value = cause;
  }

  watch(isConnected, (connected) => {
    if (connected || rates.value === undefined) return;
    topicRates.pause();
    triggerRef(rates);
  });
  usePoll(
    ask,
    () => interest.intervalMs.value ?? 0,
    computed(() => isConnected.value && interest.intervalMs.value !== undefined),
  );

  return {
    rates,
    masterTimeMs,
    clockOffsetMs: computed(() => clock.value?.offsetMs ?? 0),
    isUnsupported,
    error,
    watch: (intervalMs) => interest.express(intervalMs),
    onChanges(fn) {
      listeners.add(fn);
      tryOnScopeDispose(() => listeners.delete(fn));
    },
  };
}
