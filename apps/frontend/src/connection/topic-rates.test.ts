import type { TopicStatistic, TopicStatistics } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TopicRates } from './topic-rates.ts';

const topic = (name: string, records: number, publishedMs: number): TopicStatistic => ({
  topic: name,
  dataFormat: 'double',
  publisherId: '',
  records,
  bytes: records * 10,
  dropped: 0,
  publishedMs,
  subscribers: 0,
  valueBytes: 10,
});

const reply = (
  masterTimeMs: number,
  elements: TopicStatistic[],
  more: Partial<TopicStatistics> = {},
): TopicStatistics => ({
  cursor: masterTimeMs,
  reset: false,
  elements,
  removed: [],
  masterTimeMs,
  ...more,
});

/** Replies every 250 ms about one topic that publishes at `hz` until `stopMs`. */
function stream(rates: TopicRates, hz: number, untilMs: number, stopMs = untilMs): void {
  for (let nowMs = 0; nowMs <= untilMs; nowMs += 250) {
    const records = 100 + Math.floor((Math.min(nowMs, stopMs) * hz) / 1000);
    const publishedMs = ((records - 100) * 1000) / hz;
    rates.apply(reply(nowMs, [topic('/a', records, publishedMs)], { reset: nowMs === 0 }));
  }
}

const hzOf = (rates: TopicRates, name = '/a'): number | undefined => rates.rates.get(name)?.hz;

describe('TopicRates', () => {
  it('knows no rate after one reply', () => {
    const rates = new TopicRates();
    stream(rates, 100, 0);
    expect(hzOf(rates)).toBeUndefined();
    expect(rates.cursor).toBe(0);
  });

  it('takes the rate from the difference of two replies', () => {
    const rates = new TopicRates();
    stream(rates, 100, 250);
    expect(hzOf(rates)).toBe(100);
    expect(rates.rates.get('/a')?.bytesPerSecond).toBe(1000);
  });

  it.each([200, 60, 4, 1, 0.25, 0.1])('settles at %d Hz', (hz) => {
    const rates = new TopicRates();
    stream(rates, hz, 60_000);
    expect(hzOf(rates)).toBeGreaterThan(hz * 0.7);
    expect(hzOf(rates)).toBeLessThan(hz * 1.3);
  });

  it('falls to 0 soon after a stream has stopped, and remembers what was usual', () => {
    const rates = new TopicRates();
    stream(rates, 60, 12_250, 10_000);
    expect(hzOf(rates)).toBe(0);
    expect(rates.rates.get('/a')?.usualHz).toBeCloseTo(60, 0);
  });

  it('counts a topic that appears between replies from the earlier one', () => {
    const rates = new TopicRates();
    stream(rates, 1, 1000);
    const { added } = rates.apply(reply(1250, [topic('/new', 25, 1249)]));
    expect(added.map(({ statistic }) => statistic.topic)).toEqual(['/new']);
    expect(hzOf(rates, '/new')).toBe(100);
  });

  it('does not take a single record for a stream', () => {
    const rates = new TopicRates();
    stream(rates, 1, 1000);
    rates.apply(reply(1250, [topic('/setting', 1, 1249)]));
    expect(hzOf(rates, '/setting')).toBe(0.5);
    rates.apply(reply(5000, []));
    expect(hzOf(rates, '/setting')).toBe(0);
    expect(rates.rates.get('/setting')?.usualHz).toBeUndefined();
  });

  it('goes on without a jump after a break', () => {
    const rates = new TopicRates();
    stream(rates, 100, 5000);
    rates.apply(reply(65_000, [topic('/a', 600, 5000)]));
    expect(hzOf(rates)).toBe(100);
    rates.apply(reply(65_250, [topic('/a', 625, 65_250)]));
    expect(hzOf(rates)).toBe(100);
  });

  it('removes what was deleted, also when it came back in the same reply', () => {
    const rates = new TopicRates();
    stream(rates, 10, 1000);
    const before = rates.rates.get('/a');
    const changes = rates.apply(reply(1250, [topic('/a', 1, 1250)], { removed: ['/a', '/other'] }));
    expect(changes.removed).toEqual([before]);
    expect(changes.added).toHaveLength(1);
    expect(rates.rates.get('/a')).not.toBe(before);
  });

  it('starts over with a full list and keeps the topics it names [EX-12]', () => {
    const rates = new TopicRates();
    rates.apply(reply(0, [topic('/a', 5, 0), topic('/b', 5, 0)], { reset: true }));
    const kept = rates.rates.get('/a');
    const changes = rates.apply(
      reply(250, [topic('/a', 1, 250), topic('/c', 1, 250)], { reset: true }),
    );
    expect(changes.removed.map(({ statistic }) => statistic.topic)).toEqual(['/b']);
    expect(changes.added.map(({ statistic }) => statistic.topic)).toEqual(['/c']);
    expect(rates.rates.get('/a')).toBe(kept);
    rates.apply(reply(500, [topic('/a', 26, 500)]));
    expect(hzOf(rates)).toBe(100);
  });

  it('keeps 10 000 topics apart', () => {
    const rates = new TopicRates();
    const all = (records: number, nowMs: number) =>
      Array.from({ length: 10_000 }, (_, i) => topic(`/${i}`, records * (1 + (i % 5)), nowMs));
    rates.apply(reply(0, all(0, 0), { reset: true }));
    for (let i = 1; i <= 12; i++) rates.apply(reply(i * 250, all(i * 10, i * 250)));
    expect(rates.rates.size).toBe(10_000);
    const wrong = [...rates.rates.values()].filter(({ hz }, i) => hz !== 40 * (1 + (i % 5)));
    expect(wrong).toEqual([]);
  });
});
