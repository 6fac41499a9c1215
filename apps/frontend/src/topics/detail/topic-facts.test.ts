import { describe, expect, it } from 'vitest';
import type { TopicRate } from '../../connection/topic-rates.ts';
import { formatNumber } from '../../ui/readouts/format-number.ts';
import { lifeOf, topicFacts } from './topic-facts.ts';

const NOW = 1_000_000;
const rateOf = (more: Partial<TopicRate['statistic']> = {}, dropped = 0): TopicRate => ({
  statistic: {
    topic: '/a',
    dataFormat: 'vector3',
    publisherId: 'id',
    records: 1000,
    bytes: 74_000,
    dropped: 0,
    publishedMs: NOW - 2,
    subscribers: 3,
    valueBytes: 74,
    ...more,
  },
  hz: 99.8,
  bytesPerSecond: 7400,
  droppedPerSecond: dropped,
  usualHz: 100,
});

describe('topicFacts', () => {
  it('writes what the master counts', () => {
    expect(topicFacts(rateOf(), NOW)).toEqual({
      rate: { digits: '99.8', unit: 'Hz' },
      age: { digits: '2', unit: 'ms' },
      bandwidth: { digits: '7.4', unit: 'kB/s' },
      dropped: { digits: '0' },
      isDropping: false,
      subscribers: { digits: '3' },
      publisherId: 'id',
      isPublished: true,
    });
  });

  it('says when records are dropped now', () => {
    const facts = topicFacts(rateOf({ dropped: 1200 }, 4), NOW);
    expect(facts.dropped.digits).toBe(formatNumber(1200));
    expect(facts.isDropping).toBe(true);
  });

  it('leaves out what is not known', () => {
    expect(topicFacts(undefined, NOW).rate.digits).toBe('–');
    expect(topicFacts(rateOf({ publishedMs: 0 }), NOW).age.digits).toBe('–');
  });
});

describe('lifeOf', () => {
  it('tells a topic that ended from one that never had a value', () => {
    expect(lifeOf(rateOf(), undefined, NOW)).toBe('live');
    expect(lifeOf(rateOf({ dataFormat: '' }), NOW - 1, NOW)).toBe('ended');
    expect(lifeOf(undefined, NOW - 1, NOW)).toBe('ended');
    expect(lifeOf(undefined, undefined, NOW)).toBe('waiting');
  });

  it('calls a topic live whose first record came after the master had counted', () => {
    expect(lifeOf(undefined, NOW, 0)).toBe('live');
    expect(lifeOf(undefined, NOW, NOW - 1)).toBe('live');
    expect(lifeOf(rateOf({ dataFormat: '' }), NOW, NOW - 1)).toBe('live');
  });
});
