import type { TopicRecord } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import type { TopicRate } from '../../connection/topic-rates.ts';
import { SPARK_SAMPLES } from './sparkline.ts';
import { RowValues } from './row-values.ts';

const rateOf = (
  topic: string,
  more: { hz?: number; dataFormat?: string; valueBytes?: number } = {},
) =>
  ({
    statistic: {
      topic,
      dataFormat: more.dataFormat ?? 'double',
      publisherId: '',
      records: 1,
      bytes: 0,
      dropped: 0,
      publishedMs: 0,
      subscribers: 0,
      valueBytes: more.valueBytes ?? 10,
    },
    hz: more.hz ?? 60,
    bytesPerSecond: 0,
    droppedPerSecond: 0,
    usualHz: undefined,
  }) satisfies TopicRate;

const recordOf = (topic: string, value: number) =>
  ({ topic, format: 'double', value, timestampMs: undefined, clientId: '' }) as TopicRecord;

function setUp() {
  const subscriptions = new Map<
    string,
    { maxRateHz: number; emit: (record: TopicRecord) => void }
  >();
  const log: string[] = [];
  const values = new RowValues((topic, maxRateHz, emit) => {
    subscriptions.set(topic, { maxRateHz, emit });
    log.push(`+${topic}`);
    return () => {
      subscriptions.delete(topic);
      log.push(`-${topic}`);
    };
  });
  const publish = (topic: string, value: number) =>
    subscriptions.get(topic)?.emit(recordOf(topic, value));
  return { values, subscriptions, log, publish };
}

describe('RowValues', () => {
  it('subscribes to the rows on screen and to no others', () => {
    const { values, log } = setUp();
    const [a, b, c] = [rateOf('/a'), rateOf('/b'), rateOf('/c')];
    values.show([a, b]);
    values.show([b, c]);
    values.show([b, c]);
    expect(log).toEqual(['+/a', '+/b', '-/a', '+/c']);
    values.close();
    expect(log.slice(4)).toEqual(['-/b', '-/c']);
  });

  it('reads rows 8 times a second, large values once', () => {
    const { values, subscriptions } = setUp();
    values.show([rateOf('/a'), rateOf('/image', { valueBytes: 100_000 })]);
    expect(subscriptions.get('/a')?.maxRateHz).toBe(8);
    expect(subscriptions.get('/image')?.maxRateHz).toBe(1);
  });

  it('lets go of a topic whose value ended, so that it can be forgotten [TD-41]', () => {
    const { values, subscriptions, publish } = setUp();
    const rate = rateOf('/a');
    values.show([rate]);
    publish('/a', 5);
    rate.statistic = { ...rate.statistic, dataFormat: '' };
    values.show([rate]);
    expect(subscriptions.size).toBe(0);
    expect(values.get('/a')?.text).toBeUndefined();
  });

  it('subscribes again when a topic was deleted and came back', () => {
    const { values, log } = setUp();
    values.show([rateOf('/a')]);
    values.show([rateOf('/a')]);
    expect(log).toEqual(['+/a', '-/a', '+/a']);
  });

  it('shows the newest value, also after scrolling away and back', () => {
    const { values, publish } = setUp();
    const rate = rateOf('/a');
    values.show([rate]);
    publish('/a', 1);
    publish('/a', 2);
    expect(values.get('/a')?.text).toBe('2.00');
    values.show([]);
    values.show([rate]);
    expect(values.get('/a')?.text).toBe('2.00');
  });

  it('keeps a bounded number of values', () => {
    const { values } = setUp();
    for (let i = 0; i < 1000; i++) values.show([rateOf(`/${i}`)]);
    const kept = Array.from({ length: 1000 }, (_, i) => values.get(`/${i}`)).filter(Boolean);
    expect(kept).toHaveLength(256);
    expect(values.get('/999')).toBeDefined();
  });

  it('stands still while paused and shows the newest value afterwards', () => {
    const { values, publish } = setUp();
    values.show([rateOf('/a')]);
    publish('/a', 1);
    values.setPaused(true);
    publish('/a', 2);
    publish('/a', 3);
    expect(values.get('/a')?.text).toBe('1.00');
    values.setPaused(false);
    expect(values.get('/a')?.text).toBe('3.00');
  });

  it('shows the first value of a row that appears during a pause', () => {
    const { values, publish } = setUp();
    values.setPaused(true);
    values.show([rateOf('/a')]);
    expect(values.takeFirst()).toBe(false);
    publish('/a', 1);
    expect(values.get('/a')?.text).toBe('1.00');
    expect(values.takeFirst()).toBe(true);
    expect(values.takeFirst()).toBe(false);
  });
});

describe('the sparkline of a row', () => {
  it('holds the last 5 s and nothing for topics that rest', () => {
    const { values, publish } = setUp();
    const live = rateOf('/live');
    values.show([live, rateOf('/rests', { hz: 0.1 })]);
    for (let i = 0; i < 60; i++) {
      publish('/live', i);
      values.sample(i * 125);
    }
    expect(values.get('/live')?.spark.values).toHaveLength(SPARK_SAMPLES);
    expect(values.get('/live')?.spark.values.at(-1)).toBe(59);
    expect(values.get('/rests')?.spark.values).toEqual([]);
  });

  it('does not mix activity into numbers that are still on their way', () => {
    const { values, publish } = setUp();
    values.show([rateOf('/a', { hz: 100 })]);
    values.sample(0);
    publish('/a', 5);
    values.sample(125);
    expect(values.get('/a')?.spark.values).toEqual([5]);
  });

  it('shows activity for what is not a number', () => {
    const { values, subscriptions } = setUp();
    values.show([rateOf('/text', { hz: 3 })]);
    subscriptions
      .get('/text')
      ?.emit({ ...recordOf('/text', 0), format: 'string', value: 'x' } as TopicRecord);
    values.sample(0);
    expect(values.get('/text')?.spark.values).toEqual([3]);
  });
});

describe('the flash of a row', () => {
  const grow = (rate: { statistic: TopicRate['statistic'] }) =>
    (rate.statistic = { ...rate.statistic, records: rate.statistic.records + 1 });

  it('comes with each update of a topic that rests in between', () => {
    const { values } = setUp();
    const rate = rateOf('/a', { hz: 1 });
    values.show([rate]);
    values.sample(0);
    for (let i = 1; i <= 3; i++) {
      grow(rate);
      values.sample(i * 1000);
      values.sample(i * 1000 + 125);
    }
    expect(values.get('/a')?.flashes).toBe(3);
  });

  it('comes once in a while for a topic that never rests, not when it comes on screen', () => {
    const { values } = setUp();
    const rate = rateOf('/a', { hz: 60 });
    values.show([rate]);
    const flashes: number[] = [];
    for (let ms = 0; ms < 12_000; ms += 125) {
      grow(rate);
      values.sample(ms);
      if ((values.get('/a')?.flashes ?? 0) > flashes.length) flashes.push(ms);
    }
    expect(flashes).toHaveLength(3);
    expect(flashes[0]).toBeGreaterThan(0);
    expect(flashes.map((ms) => ms - flashes[0]!)).toEqual([0, 4000, 8000]);
  });
});
