import { describe, expect, it } from 'vitest';
import type { TopicRate } from '../../connection/topic-rates.ts';
import { hasChanged, liveTopic } from './live-topic.ts';

const NOW_MS = 1_000_000;
const rate = (publishedMs: number): TopicRate => ({
  statistic: {
    topic: '/a',
    dataFormat: '',
    publisherId: '',
    records: 0,
    bytes: 0,
    dropped: 0,
    publishedMs,
    subscribers: 0,
    valueBytes: 0,
  },
  hz: undefined,
  bytesPerSecond: undefined,
  droppedPerSecond: undefined,
  usualHz: undefined,
});

describe('hasChanged', () => {
  it('reports the first publication, also of a record without a value', () => {
    const before = liveTopic(rate(0), undefined, NOW_MS);
    const after = liveTopic(rate(NOW_MS - 20), undefined, NOW_MS);
    expect(before.ageMs).toBeUndefined();
    expect(hasChanged(before, after)).toBe(true);
    expect(hasChanged(after, liveTopic(rate(NOW_MS - 20), undefined, NOW_MS + 5))).toBe(false);
  });
});
