import type { TopicRate } from '../connection/topic-rates.ts';

/** What one client publishes. */
export interface PublisherRate {
  readonly hz: number;
  readonly topics: number;
}

/** Rates and topics summed by publisher. The master's own topics are left out. */
export function publisherRates(rates: Iterable<TopicRate>): Map<string, PublisherRate> {
  const sums = new Map<string, { hz: number; topics: number }>();
  for (const { statistic, hz } of rates) {
    if (statistic.publisherId === '' || statistic.dataFormat === '') continue;
    const sum = sums.get(statistic.publisherId) ?? { hz: 0, topics: 0 };
    sum.hz += hz ?? 0;
    sum.topics += 1;
    sums.set(statistic.publisherId, sum);
  }
  return sums;
}
