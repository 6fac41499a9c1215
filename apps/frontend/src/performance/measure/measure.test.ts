import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { Durations, median, percentile } from './durations.ts';
import { binOf, binStartMs, histogramOf } from './histogram.ts';
import { overTime } from './over-time.ts';
import { Pace } from './pace.ts';

describe('durations', () => {
  it('have percentiles by nearest rank', () => {
    const durations = new Durations();
    for (let ms = 100; ms >= 1; ms--) durations.add(ms, 0);
    expect(durations.summary()).toMatchObject({
      count: 100,
      minMs: 1,
      meanMs: 50.5,
      p50Ms: 50,
      p95Ms: 95,
      p99Ms: 99,
      maxMs: 100,
      jitterMs: 1,
    });
  });

  it('equal the value when there is one', () => {
    const durations = new Durations();
    durations.add(7, 0);
    expect(durations.summary()).toMatchObject({ p50Ms: 7, p99Ms: 7, jitterMs: 0 });
  });

  it('say nothing before the first', () => {
    expect(new Durations().summary()).toBeUndefined();
    expect(median([])).toBeUndefined();
  });

  it('stay bounded, and keep their percentiles about', () => {
    const durations = new Durations();
    for (let i = 0; i < 500_000; i++) durations.add(i % 1000, i);
    expect(durations.values.length).toBeLessThanOrEqual(200_000);
    const summary = durations.summary()!;
    expect(summary.count).toBe(500_000);
    expect(Math.abs(summary.p95Ms - 950)).toBeLessThan(10);
  });

  it('have percentiles that are members, in order', () => {
    fc.assert(
      fc.property(
        fc.array(fc.double({ min: 0, max: 1e6, noNaN: true }), { minLength: 1 }),
        (all) => {
          const sorted = [...all].sort((a, b) => a - b);
          const [p50, p99] = [percentile(sorted, 0.5), percentile(sorted, 0.99)];
          return all.includes(p50) && all.includes(p99) && p50 <= p99;
        },
      ),
    );
  });
});

describe('histogram', () => {
  it('puts an edge into the bin it begins', () => {
    for (let bin = 1; bin < 140; bin++) expect(binOf(binStartMs(bin))).toBe(bin);
  });

  it('counts every duration once', () => {
    fc.assert(
      fc.property(
        fc.array(fc.double({ min: 0, max: 1e9, noNaN: true }), { minLength: 1 }),
        (all) => {
          const { counts } = histogramOf('k', 't', all)!;
          return counts.reduce((a, b) => a + b, 0) === all.length;
        },
      ),
    );
  });

  it('is none of nothing', () => expect(histogramOf('k', 't', [])).toBeUndefined());
});

describe('over time', () => {
  it('leaves gaps where nothing came', () => {
    const durations = new Durations();
    durations.add(1, 1100);
    durations.add(3, 1200);
    durations.add(9, 1600);
    const curve = overTime('k', 't', durations, 1000)!;
    expect(curve.x.values).toEqual([0.125, 0.375, 0.625]);
    expect(curve.lines.map(({ values }) => values)).toEqual([
      [1, null, 9],
      [3, null, 9],
    ]);
  });

  it('has a bounded number of points', () => {
    const durations = new Durations();
    for (let i = 0; i < 5000; i++) durations.add(1, i * 100);
    expect(overTime('k', 't', durations, 0)!.x.values.length).toBeLessThanOrEqual(121);
  });
});

describe('pace', () => {
  it('keeps the rate with late timers', () => {
    const pace = new Pace(100, 0);
    expect([0, 4, 12, 35].map((nowMs) => pace.due(nowMs))).toEqual([1, 0, 1, 2]);
    expect(pace.skipped).toBe(0);
  });

  it('makes up for a pause only so far', () => {
    const pace = new Pace(100, 0, 3);
    expect(pace.due(1000)).toBe(3);
    expect(pace.skipped).toBe(98);
    expect(pace.due(1001)).toBe(0);
  });
});
