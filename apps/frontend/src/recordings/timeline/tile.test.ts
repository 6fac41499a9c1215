import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { levelOf, TileBuilder, tileGrid, tileLengthMs, tilesOf } from './tile.ts';

describe('a tile', () => {
  it('has the lowest and highest number of each bucket', () => {
    const builder = new TileBuilder({ fromMs: 100, bucketMs: 10, buckets: 3 });
    for (const [timeMs, number] of [
      [100, 5],
      [105, -1],
      [109.9, 2],
      [120, 7],
    ] as const)
      builder.add(timeMs, { numbers: [number] });
    const { counts, lines, isWhole } = builder.tile(true);
    expect([...counts]).toEqual([3, 0, 1]);
    expect([...lines[0]!.low]).toEqual([-1, Number.NaN, 7]);
    expect([...lines[0]!.high]).toEqual([5, Number.NaN, 7]);
    expect(isWhole).toBe(true);
  });

  it('leaves out what is before and after it, and numbers that are none', () => {
    const builder = new TileBuilder({ fromMs: 100, bucketMs: 10, buckets: 1 });
    builder.add(99, { numbers: [1] });
    builder.add(110, { numbers: [1] });
    builder.add(101, { numbers: [Number.NaN, 4] });
    const { counts, lines } = builder.tile(false);
    expect([...counts]).toEqual([1]);
    expect(lines.map(({ low }) => low[0])).toEqual([Number.NaN, 4]);
  });

  it('given away does not change any more', () => {
    const builder = new TileBuilder({ fromMs: 0, bucketMs: 1, buckets: 1 });
    const before = builder.tile(false);
    builder.add(0, { numbers: [] });
    expect(before.counts[0]).toBe(0);
  });
});

describe('levels of detail', () => {
  it('have buckets of at most a pixel, and no more than two in one', () => {
    fc.assert(
      fc.property(fc.double({ min: 0.07, max: 5000, noNaN: true }), (msPerPx) => {
        const bucketMs = 2 ** levelOf(msPerPx);
        expect(bucketMs).toBeLessThanOrEqual(msPerPx);
        expect(bucketMs).toBeGreaterThan(msPerPx / 2.0001);
      }),
    );
  });

  it('cover a span with as few tiles as touch it', () => {
    const length = tileLengthMs(2);
    expect(tilesOf(2, { fromMs: 0, untilMs: length })).toEqual({ first: 0, last: 0 });
    expect(tilesOf(2, { fromMs: 10, untilMs: length + 1 })).toEqual({ first: 0, last: 1 });
    expect(tileGrid(2, 1)).toEqual({ fromMs: length, bucketMs: 4, buckets: 512 });
  });
});
