import type { TopicStatistic, TopicStatistics } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TopicRates } from './topic-rates.ts';

function statistic(topic: string, records: number, changes: Partial<TopicStatistic> = {}) {
  return {
    topic,
    dataFormat: 'double',
    publisherId: 'p',
    records,
    bytes: records * 50,
    dropped: 0,
    publishedMs: 0,
    subscribers: 0,
    valueBytes: 50,
    ...changes,
  };
}

function reply(masterTimeMs: number, ...elements: TopicStatistic[]): TopicStatistics {
  return { cursor: masterTimeMs, reset: false, elements, removed: [], masterTimeMs };
}

describe('TopicRates', () => {
  it('a rate is unknown at first, then the difference over the master’s time [EX-11]', () => {
    const rates = new TopicRates();
    rates.apply({ ...reply(1000, statistic('/a', 100)), reset: true });
    expect(rates.rates.get('/a')?.hz).toBeUndefined();
    rates.apply(reply(2000, statistic('/a', 160)));
    expect(rates.rates.get('/a')).toMatchObject({ hz: 60, bytesPerSecond: 3000 });
    expect(rates.cursor).toBe(2000);
  });

  it('no rate is known while nothing is measured; it starts afresh after that', () => {
    const rates = new TopicRates();
    rates.apply({ ...reply(1000, statistic('/a', 100)), reset: true });
    rates.apply(reply(2000, statistic('/a', 160)));
    rates.pause();
    expect(rates.rates.get('/a')).toMatchObject({
      hz: undefined,
      bytesPerSecond: undefined,
      droppedPerSecond: undefined,
      statistic: { records: 160 },
    });
    rates.apply({ ...reply(60_000, statistic('/a', 500)), reset: true });
    expect(rates.rates.get('/a')?.hz).toBeUndefined();
    rates.apply(reply(61_000, statistic('/a', 530)));
    expect(rates.rates.get('/a')?.hz).toBe(30);
  });

  it('a topic that appears between two replies counts from the earlier one', () => {
    const rates = new TopicRates();
    rates.apply({ ...reply(1000), reset: true });
    rates.apply(reply(2000, statistic('/new', 30)));
    expect(rates.rates.get('/new')?.hz).toBe(30);
  });

  it('is a mean over about two seconds', () => {
    const rates = new TopicRates();
    rates.apply({ ...reply(0, statistic('/a', 0)), reset: true });
    for (let second = 1; second <= 5; second += 1) {
      rates.apply(reply(second * 1000, statistic('/a', second * 10)));
    }
    rates.apply(reply(6000, statistic('/a', 80)));
    expect(rates.rates.get('/a')?.hz).toBe((80 - 40) / 2);
  });

  it('falls to 0 when a topic rests, though no reply names it any more [EX-13]', () => {
    const rates = new TopicRates();
    rates.apply({ ...reply(0, statistic('/a', 0)), reset: true });
    rates.apply(reply(1000, statistic('/a', 50, { publishedMs: 1000 })));
    for (let second = 2; second <= 60; second += 1) rates.apply(reply(second * 1000));
    expect(rates.rates.get('/a')?.hz).toBe(0);
  });

  it('measures a slow topic by the time between its records', () => {
    const rates = new TopicRates();
    rates.apply({ ...reply(0, statistic('/slow', 1, { publishedMs: 1 })), reset: true });
    rates.apply(reply(10_000, statistic('/slow', 2, { publishedMs: 10_001 })));
    rates.apply(reply(11_000));
    rates.apply(reply(14_000));
    expect(rates.rates.get('/slow')?.hz).toBeCloseTo(0.1, 3);
  });

  it('forgets removed topics, and everything on a reset [EX-12]', () => {
    const rates = new TopicRates();
    rates.apply({ ...reply(0, statistic('/a', 1), statistic('/b', 1)), reset: true });
    rates.apply({ ...reply(1000), removed: ['/a'] });
    expect([...rates.rates.keys()]).toEqual(['/b']);
    rates.apply({ ...reply(2000, statistic('/c', 1)), reset: true });
    expect([...rates.rates.keys()]).toEqual(['/c']);
  });

  it('counts drops per second', () => {
    const rates = new TopicRates();
    rates.apply({ ...reply(0, statistic('/a', 0)), reset: true });
    rates.apply(reply(1000, statistic('/a', 50, { dropped: 6 })));
    expect(rates.rates.get('/a')?.droppedPerSecond).toBe(6);
  });
});
