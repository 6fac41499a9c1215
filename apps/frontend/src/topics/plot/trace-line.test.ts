import { describe, expect, it } from 'vitest';
import { SeriesRing } from '../history/series-ring.ts';
import { aLine } from './testing/a-line.ts';
import { gapOf, TracedLine } from './trace-line.ts';
import type { TimeWindow, TraceOptions } from './trace-options.ts';

const WINDOW: TimeWindow = { startMs: 0, endMs: 1000, width: 100 };

function strokesOf(traced: TracedLine, more: Partial<TraceOptions> = {}) {
  const strokes: [string, number, number][] = [];
  traced.trace(
    { window: WINDOW, toY: (value) => value, isStepped: false, ...more },
    {
      moveTo: (x, y) => strokes.push(['M', Math.round(x), y]),
      lineTo: (x, y) => strokes.push(['L', Math.round(x), y]),
    },
  );
  // An isolated point is drawn as a very short line.
  return strokes.filter(([kind, x, y], i) => {
    const before = strokes[i - 1];
    return !(kind === 'L' && before?.[0] === 'M' && before[1] === x && before[2] === y);
  });
}

describe('a line with few points', () => {
  it('connects them', () => {
    const line = aLine([
      [0, 1],
      [500, 2],
      [1000, 3],
    ]);
    expect(strokesOf(new TracedLine(line))).toEqual([
      ['M', 0, 1],
      ['L', 50, 2],
      ['L', 100, 3],
    ]);
  });

  it('begins one point before the window and ends one after it', () => {
    const line = aLine([
      [-300, 0],
      [-100, 1],
      [500, 2],
      [1100, 3],
      [1300, 4],
    ]);
    expect(strokesOf(new TracedLine(line)).map(([, x]) => x)).toEqual([-10, 50, 110]);
  });

  it('leaves gaps as gaps, and what is no number or infinite out', () => {
    const away = aLine([
      ...Array.from({ length: 30 }, (_, i): [number, number] => [i * 10, 1]),
      [2000, 2],
      [2010, 2],
    ]);
    const window = { startMs: 0, endMs: 3000, width: 300 };
    const kinds = strokesOf(new TracedLine(away), { window }).map(([kind]) => kind);
    expect(kinds.filter((kind) => kind === 'M')).toHaveLength(2);
    const odd = aLine([
      [0, 1],
      [100, Number.NaN],
      [200, 2],
      [300, Infinity],
      [400, 3],
    ]);
    expect(strokesOf(new TracedLine(odd)).map(([kind]) => kind)).toEqual(['M', 'M', 'M']);
    expect(new TracedLine(odd).rangeIn(WINDOW)).toEqual({ min: 1, max: 3 });
  });

  it('holds a value until the next one when asked to', () => {
    const line = aLine([
      [0, 0],
      [500, 1],
    ]);
    expect(strokesOf(new TracedLine(line), { isStepped: true })).toEqual([
      ['M', 0, 0],
      ['L', 50, 0],
      ['L', 50, 1],
    ]);
  });
});

describe('a line with many points', () => {
  const value = (i: number): number => (i === 5432 ? 99 : i === 6001 ? -50 : Math.sin(i));

  it('keeps every peak with few strokes', () => {
    const line = aLine(Array.from({ length: 10_000 }, (_, i) => [i / 10, value(i)]));
    const traced = new TracedLine(line);
    const strokes = strokesOf(traced);
    expect(strokes.length).toBeLessThan(450);
    const ys = strokes.map(([, , y]) => y);
    expect([Math.min(...ys), Math.max(...ys)]).toEqual([-50, 99]);
    expect(traced.rangeIn(WINDOW)).toEqual({ min: -50, max: 99 });
    expect(strokes.filter(([kind]) => kind === 'M')).toHaveLength(1);
  });

  it('says the same after moving on with time as when it is counted at once', () => {
    const ring = new SeriesRing(1, 8000);
    const moving = new TracedLine(ring.line(0));
    const width = 100;
    for (let i = 0; i < 12_000; i++) {
      ring.push(i, [value(i)]);
      if (i % 37 === 0 && i > 2000) {
        const window = { startMs: i - 2000, endMs: i, width };
        moving.rangeIn(window);
      }
    }
    const window = { startMs: 9990, endMs: 11_990, width };
    const fresh = new TracedLine(ring.line(0));
    expect(moving.rangeIn(window)).toEqual(fresh.rangeIn(window));
    // The first pixel may include points before the window, which only the moving line has processed.
    expect(strokesOf(moving, { window }).slice(8)).toEqual(strokesOf(fresh, { window }).slice(8));
  });

  it('shows what lies back after a jump, though the data goes on', () => {
    const ring = new SeriesRing(1, 20_000);
    for (let i = 0; i < 10_000; i++) ring.push(i, [value(i)]);
    const traced = new TracedLine(ring.line(0));
    traced.rangeIn({ startMs: 8000, endMs: 10_000, width: 100 });
    expect(traced.rangeIn({ startMs: 5000, endMs: 7000, width: 100 })).toEqual({
      min: -50,
      max: 99,
    });
    for (let i = 10_000; i < 12_000; i++) ring.push(i, [1000]);
    expect(traced.rangeIn({ startMs: 5000, endMs: 7000, width: 100 })?.max).toBe(99);
    expect(traced.rangeIn({ startMs: 9500, endMs: 11_500, width: 100 })?.max).toBe(1000);
  });

  it('leaves gaps as gaps', () => {
    const line = aLine(
      Array.from({ length: 2000 }, (_, i) => [i < 1000 ? i : i + 5000, 1] as const),
    );
    const window = { startMs: 0, endMs: 7000, width: 100 };
    const moves = strokesOf(new TracedLine(line), { window }).filter(([kind]) => kind === 'M');
    expect(moves).toHaveLength(2);
  });
});

describe('gapOf', () => {
  it('is well beyond the usual distance, and at least a second', () => {
    expect(gapOf(aLine([]))).toBe(Infinity);
    const fast = Array.from({ length: 100 }, (_, i): [number, number] => [i * 10, 0]);
    expect(gapOf(aLine(fast))).toBe(1000);
    const slow = Array.from({ length: 99 }, (_, i): [number, number] => [3000 + i * 2000, 0]);
    expect(gapOf(aLine([...fast, ...slow]))).toBe(16_000);
  });
});
