import { shallowRef, watch, type ShallowRef } from 'vue';
import { useConnection } from '../connection/useConnection.ts';
import { publisherRates, type PublisherRate } from './publisher-rates.ts';

const INTERVAL_MS = 1000;
const HISTORY = 28;

/** Publishing rate of a client, now and over the last half minute. */
export interface PublisherTrend extends PublisherRate {
  /** Records per second, oldest first. */
  readonly history: readonly number[];
}

/** Rates by client, once a second while the calling component is mounted; `undefined` without statistics. */
export function usePublisherRates(): Readonly<
  ShallowRef<ReadonlyMap<string, PublisherTrend> | undefined>
> {
  const { topics } = useConnection();
  const trends = shallowRef<ReadonlyMap<string, PublisherTrend>>();
  topics.watch(INTERVAL_MS);
  watch(topics.rates, (rates) => {
    if (!rates) return;
    const before = trends.value;
    const next = new Map<string, PublisherTrend>();
    for (const [id, rate] of publisherRates(rates.values())) {
      const past = before?.get(id)?.history ?? [];
      const history = rate.hz === undefined ? past : [...past, rate.hz].slice(-HISTORY);
      next.set(id, { ...rate, history });
    }
    trends.value = next;
  });
  return trends;
}
