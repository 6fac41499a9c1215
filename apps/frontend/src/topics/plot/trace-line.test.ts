import { describe, expect, it } from 'vitest';
import { SeriesRing } from '../history/series-ring.ts';
import { gapOf, traceLine, type PathSink, type TraceOptions } from './trace-line.ts';

function trace(points: readonly (readonly [number, number])[], more: Partial<TraceOptions> = {}) {
  const ring = new SeriesRing(1);
  for (const [timeMs, value] of points) ring.push(timeMs, [value]);
  const strokes: [string, number, number][] = [];
  const sink: PathSink = {
    moveTo: (x, y) => strokes.push(['M', x, y]),
    lineTo: (x, y) => strokes.push(['L', x, y]),
  };
  const options: TraceOptions = {
    window: { startMs: 0, endMs: 1000, width: 100 },
    toY: (value) => value,
    gapMs: 1000,
    isStepped: false,
    ...more,
  };
  traceLine(ring, 0, options, sink);
  return strokes;
}

describe('traceLine', () => {
  it('connects the points', () => {
    expect(
      trace([
        [0, 1],
        [500, 2],
        [1000, 3],
      ]),
    ).toEqual([
      ['M', 0, 1],
      ['L', 50, 2],
      ['L', 100, 3],
    ]);
  });

  it('begins one point before the window and ends one after it', () => {
    const xs = trace([
      [-300, 0],
      [-100, 1],
      [500, 2],
      [1100, 3],
      [1300, 4],
    ]).map(([, x]) => Math.round(x));
    expect(xs).toEqual([-10, 50, 110]);
  });

  it('leaves gaps as gaps', () => {
    const kinds = trace(
      [
        [0, 1],
        [100, 1],
        [900, 2],
        [950, 2],
      ],
      { gapMs: 500 },
    ).map(([kind]) => kind);
    expect(kinds).toEqual(['M', 'L', 'M', 'L']);
  });

  it('leaves out what is not a number', () => {
    expect(
      trace([
        [0, 1],
        [100, Number.NaN],
        [200, 2],
      ]).map(([kind]) => kind),
    ).toEqual(['M', 'M']);
  });

  it('holds a value until the next one when asked to', () => {
    expect(
      trace(
        [
          [0, 0],
          [500, 1],
        ],
        { isStepped: true },
      ),
    ).toEqual([
      ['M', 0, 0],
      ['L', 50, 0],
      ['L', 50, 1],
    ]);
  });

  it('keeps every peak of dense points, with few strokes', () => {
    const points = Array.from({ length: 10_000 }, (_, i): [number, number] => [
      i / 10,
      i === 5432 ? 99 : Math.sin(i),
    ]);
    const strokes = trace(points);
    expect(strokes.length).toBeLessThan(450);
    expect(Math.max(...strokes.map(([, , y]) => y))).toBe(99);
    expect(strokes.filter(([kind]) => kind === 'M')).toHaveLength(1);
  });
});

describe('gapOf', () => {
  it('is well beyond the usual distance, and at least a second', () => {
    const ring = new SeriesRing(1);
    expect(gapOf(ring)).toBe(Infinity);
    for (let i = 0; i < 100; i++) ring.push(i * 10, [0]);
    expect(gapOf(ring)).toBe(1000);
    for (let i = 1; i < 100; i++) ring.push(1000 + i * 2000, [0]);
    expect(gapOf(ring)).toBe(16_000);
  });
});
