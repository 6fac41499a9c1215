import type { TopicRate } from '../connection/topic-rates.ts';

/** Publishing rate of a client. */
export interface PublisherRate {
  /** `undefined` until a rate is known. */
  readonly hz: number | undefined;
  readonly topics: number;
}

/** Rates and numbers of topics by publisher, without the master's own topics. */
export function publisherRates(rates: Iterable<TopicRate>): Map<string, PublisherRate> {
  const sums = new Map<string, { hz: number | undefined; topics: number }>();
  for (const { statistic, hz } of rates) {
    if (statistic.publisherId === '' || statistic.dataFormat === '') continue;
    const sum = sums.get(statistic.publisherId) ?? { hz: undefined, topics: 0 };
    if (hz !== undefined) sum.hz = (sum.hz ?? 0) + hz;
    sum.topics += 1;
    sums.set(statistic.publisherId, sum);
  }
  return sums;
}
