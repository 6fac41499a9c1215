import { describe, expect, it } from 'vitest';
import type { TopicRate } from '../../connection/topic-rates.ts';
import { RowValue } from '../../topics/rows/row-value.ts';
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

describe('a value that the master has not counted yet', () => {
  it('is shown with what its record says', () => {
    const value = new RowValue(0);
    value.handleRecord({
      topic: '/a',
      format: 'double',
      value: 2,
      timestampMs: undefined,
      clientId: 'id',
    });
    for (const counted of [undefined, rate(0)]) {
      expect(liveTopic(counted, value, false, NOW_MS)).toMatchObject({
        text: '2.00',
        format: 'double',
        publisherId: 'id',
        ageMs: 0,
        hz: undefined,
        isStale: false,
      });
    }
  });
});

describe('a value whose client has left', () => {
  it('is as stale on the canvas as in the list of topics', () => {
    const old = rate(NOW_MS - 6000);
    expect(liveTopic(old, undefined, false, NOW_MS).isStale).toBe(false);
    expect(liveTopic(old, undefined, true, NOW_MS).isStale).toBe(true);
  });
});
