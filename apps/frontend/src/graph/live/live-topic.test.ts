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
    const before = liveTopic(rate(0), undefined, false, NOW_MS);
    const after = liveTopic(rate(NOW_MS - 20), undefined, false, NOW_MS);
    expect(before.ageMs).toBeUndefined();
    expect(hasChanged(before, after)).toBe(true);
    expect(hasChanged(after, liveTopic(rate(NOW_MS - 20), undefined, false, NOW_MS + 5))).toBe(
      false,
    );
  });
});

describe('a value whose client has left', () => {
  it('is as stale on the canvas as in the list of topics', () => {
    const old = rate(NOW_MS - 6000);
    expect(liveTopic(old, undefined, false, NOW_MS).isStale).toBe(false);
    expect(liveTopic(old, undefined, true, NOW_MS).isStale).toBe(true);
  });
});
