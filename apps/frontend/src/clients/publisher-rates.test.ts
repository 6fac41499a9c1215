import { expect, it } from 'vitest';
import type { TopicRate } from '../connection/topic-rates.ts';
import { publisherRates } from './publisher-rates.ts';

it('rates are summed by publisher, without the master’s own topics', () => {
  const rate = (publisherId: string, hz: number | undefined, dataFormat = 'double') =>
    ({ statistic: { publisherId, dataFormat }, hz }) as unknown as TopicRate;
  const sums = publisherRates([
    rate('a', 60),
    rate('a', undefined),
    rate('b', undefined),
    rate('', 5),
    rate('a', 1, ''),
  ]);
  expect(Object.fromEntries(sums)).toEqual({
    a: { hz: 60, topics: 2 },
    b: { hz: undefined, topics: 1 },
  });
});
