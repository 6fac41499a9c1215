import type { TopicRecord } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { patternKey, patternRateHz } from '../../connection/live/topic-source.ts';
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
  let wanted = new Map<string, number>();
  const values = new RowValues((topics) => {
    wanted = new Map(topics.map((one) => [patternKey(one).slice(6), patternRateHz(one)!]));
  });
  const publish = (topic: string, value: number) => values.handleRecord(recordOf(topic, value));
  return {
    values,
    wanted: () => [...wanted.keys()],
    rateHz: (topic: string) => wanted.get(topic),
    publish,
  };
}

describe('RowValues', () => {
  it('wants the rows on screen and no others', () => {
    const { values, wanted, publish } = setUp();
    const [a, b, c] = [rateOf('/a'), rateOf('/b'), rateOf('/c')];
    values.show([a, b]);
    expect(wanted()).toEqual(['/a', '/b']);
    values.show([b, c]);
    expect(wanted()).toEqual(['/b', '/c']);
    publish('/a', 1);
    expect(values.get('/a')?.text).toBeUndefined();
    values.close();
    expect(wanted()).toEqual([]);
  });

  it('reads rows 8 times a second, large values once', () => {
    const { values, rateHz } = setUp();
    values.show([rateOf('/a'), rateOf('/image', { valueBytes: 100_000 })]);
    expect(rateHz('/a')).toBe(8);
    expect(rateHz('/image')).toBe(1);
  });

  it('lets go of a topic whose value ended, so that it can be forgotten [TD-41]', () => {
    const { values, wanted, publish } = setUp();
    const rate = rateOf('/a');
    values.show([rate]);
    publish('/a', 5);
    rate.statistic = { ...rate.statistic, dataFormat: '' };
    values.show([rate]);
    expect(wanted()).toEqual([]);
    expect(values.get('/a')?.text).toBeUndefined();
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

describe('named rows', () => {
  const ended = rateOf('/a', { dataFormat: '' });

  it('show the first value before the master counts the topic', () => {
    const { values, wanted, publish } = setUp();
    values.showNamed(['/a'], () => undefined);
    expect(wanted()).toEqual(['/a']);
    publish('/a', 4);
    expect(values.get('/a')?.text).toBe('4.00');
    // Statistics from before the record arrived.
    values.showNamed(['/a'], () => ended);
    values.showNamed(['/a'], () => ended);
    expect(values.get('/a')?.text).toBe('4.00');
  });

  it('take large values less often as soon as they are known to be large', () => {
    const { values, rateHz } = setUp();
    values.showNamed(['/image'], () => undefined);
    expect(rateHz('/image')).toBe(8);
    values.showNamed(['/image'], () => rateOf('/image', { valueBytes: 100_000 }));
    expect(rateHz('/image')).toBe(1);
  });

  it('lose a value that ended, and wait for the next', () => {
    const { values, wanted, publish } = setUp();
    values.showNamed(['/a'], () => undefined);
    publish('/a', 4);
    values.showNamed(['/a'], () => rateOf('/a'));
    values.showNamed(['/a'], () => ended);
    expect(values.get('/a')?.text).toBeUndefined();
    expect(wanted()).toEqual(['/a']);
    publish('/a', 5);
    values.showNamed(['/a'], () => ended);
    expect(values.get('/a')?.text).toBe('5.00');
  });

  it('keep a value that came since the counters were looked at', () => {
    const { values, publish } = setUp();
    values.showNamed(['/a'], () => rateOf('/a'));
    publish('/a', 6);
    values.showNamed(['/a'], () => ended);
    expect(values.get('/a')?.text).toBe('6.00');
    values.showNamed(['/a'], () => ended);
    expect(values.get('/a')?.text).toBeUndefined();
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
    const { values } = setUp();
    values.show([rateOf('/text', { hz: 3 })]);
    values.handleRecord({ ...recordOf('/text', 0), format: 'string', value: 'x' } as TopicRecord);
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

  it('shows what a plot of the page shows, as of the same reading', () => {
    let newest: TopicRecord | undefined = recordOf('/a', 1);
    const values = new RowValues(
      () => undefined,
      1,
      () => newest,
    );
    values.show([rateOf('/a')]);
    values.handleRecord(recordOf('/a', 0.5));
    newest = recordOf('/a', 2);
    // A record of the slower subscription, between two readings.
    values.handleRecord(recordOf('/a', 3));
    expect(values.get('/a')?.text).toBe('0.50');
    values.sample(0);
    expect(values.get('/a')?.text).toBe('2.00');
    newest = undefined;
    values.handleRecord(recordOf('/a', 4));
    expect(values.get('/a')?.text).toBe('4.00');
  });
});
