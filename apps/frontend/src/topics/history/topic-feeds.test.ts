import type { TopicRecord } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { DEFAULT_LIMITS, limitsInWords, readLimits } from './history-limits.ts';
import { nowMs } from './page-clock.ts';
import { FeedScope, TopicFeeds } from './topic-feeds.ts';

/** Creates feeds whose records the test sends. */
function setUp() {
  const listeners = new Map<string, (record: TopicRecord) => void>();
  const feeds = new TopicFeeds({
    limits: DEFAULT_LIMITS,
    publishedMs: () => undefined,
    past: () => Promise.resolve([]),
    pause: () => Promise.resolve(),
    subscribe(topic, onRecord) {
      listeners.set(topic, onRecord);
      return () => void listeners.delete(topic);
    },
  });
  const send = (topic: string, value: number, timestampMs: number): void => {
    const record = { topic, format: 'double', value, timestampMs, clientId: '' };
    listeners.get(topic)?.(record as TopicRecord);
  };
  return { feeds, send, subscribed: () => [...listeners.keys()].sort().join() };
}

describe('TopicFeeds', () => {
  it('subscribes once for all viewers, and keeps received records', () => {
    const { feeds, send, subscribed } = setUp();
    const [one, two] = [feeds.get('/a').look(), feeds.get('/a').look()];
    expect(subscribed()).toBe('/a');
    send('/a', 1, nowMs());
    one();
    one();
    expect(subscribed()).toBe('/a');
    two();
    expect(subscribed()).toBe('');
    expect(feeds.get('/a').history.count).toBe(1);
  });

  it('recognises a retained value that is sent again for a new viewer', () => {
    const { feeds, send } = setUp();
    const timeMs = nowMs() - 5000;
    const stop = feeds.get('/a').look();
    send('/a', 1, timeMs);
    stop();
    feeds.get('/a').look();
    send('/a', 1, timeMs);
    expect(feeds.get('/a').history.count).toBe(1);
    send('/a', 2, timeMs + 1000);
    expect(feeds.get('/a').history.count).toBe(2);
  });

  it('forgets topics that are in no panel any more', () => {
    const { feeds } = setUp();
    const stop = feeds.get('/a').look();
    feeds.get('/b');
    feeds.keepOnly(new Set());
    expect(feeds.size).toBe(1);
    stop();
    feeds.keepOnly(new Set());
    expect(feeds.size).toBe(0);
  });
});

describe('FeedScope', () => {
  it('looks only while its part of the page is looked at', () => {
    const { feeds, subscribed } = setUp();
    const [seen, covered] = [new FeedScope(feeds), new FeedScope(feeds)];
    seen.setActive(true);
    seen.get('/a').look();
    const stop = covered.get('/b').look();
    expect(subscribed()).toBe('/a');
    covered.setActive(true);
    expect(subscribed()).toBe('/a,/b');
    seen.setActive(false);
    expect(subscribed()).toBe('/b');
    stop();
    expect(subscribed()).toBe('');
    seen.setActive(true);
    expect(subscribed()).toBe('/a');
  });
});

it('limits are said in words, and read from what was kept', () => {
  expect(limitsInWords(DEFAULT_LIMITS)).toMatch(/^10 min or 64.* MB of each topic/);
  expect(readLimits({ minutes: 2, megabytes: 16 })).toEqual({
    maxAgeMs: 120_000,
    maxBytes: 16_000_000,
  });
  for (const stored of [undefined, 7, { minutes: -1, megabytes: '∞' }]) {
    expect(readLimits(stored)).toEqual(DEFAULT_LIMITS);
  }
});
