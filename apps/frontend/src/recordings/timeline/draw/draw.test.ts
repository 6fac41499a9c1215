import { describe, expect, it } from 'vitest';
import { TileBuilder } from '../tile.ts';
import type { Run } from '../run-log.ts';
import type { TilePiece } from '../tile-store.ts';
import { drawActivity } from './draw-activity.ts';
import { columnsOf, drawLine, rangeOf, yOf } from './draw-lines.ts';
import { quietLabels } from './draw-runs.ts';
import { tickColumns } from './draw-ticks.ts';
import { filmSlots } from './film-strip.ts';
import type { Pen, TrackView } from './track-canvas.ts';

const view: TrackView = { span: { fromMs: 0, untilMs: 100 }, widthPx: 100, heightPx: 100 };

function aTile(points: readonly (readonly [number, number])[], bucketMs = 1) {
  const builder = new TileBuilder({ fromMs: 0, bucketMs, buckets: 100 / bucketMs });
  for (const [timeMs, value] of points) builder.add(timeMs, { numbers: [value] });
  return builder.tile(true);
}
const piecesOf = (tile: ReturnType<typeof aTile>) => [{ tile, ...view.span }];

function aPen() {
  const strokes: [number, number][][] = [];
  const pen = {
    beginPath: () => undefined,
    moveTo: (x: number, y: number) => strokes.push([[x, y]]),
    lineTo: (x: number, y: number) => strokes.at(-1)?.push([x, y]),
    stroke: () => undefined,
  };
  return { strokes, pen: pen as unknown as Pen };
}

describe('lines of a track', () => {
  it('put buckets of one pixel together', () => {
    const tile = aTile(
      [
        [10, 1],
        [10.5, 9],
        [11, 4],
      ],
      0.5,
    );
    expect([...columnsOf(piecesOf(tile), 0, view)]).toMatchObject([
      { x: 10.5, low: 1, high: 9 },
      { x: 11.5, low: 4, high: 4 },
    ]);
  });

  it('are interrupted by a gap', () => {
    const { pen, strokes } = aPen();
    const tile = aTile([
      [10, 1],
      [12, 2],
      [60, 3],
      [62, 1],
    ]);
    drawLine(pen, columnsOf(piecesOf(tile), 0, view), rangeOf(tile)!, view, 20);
    expect(strokes).toHaveLength(2);
    expect(strokes[1]![0]![0]).toBeCloseTo(59.75);
  });

  it('stay inside the track', () => {
    const range = rangeOf(
      aTile([
        [1, -5],
        [2, 7],
      ]),
    )!;
    expect(range).toEqual({ low: -5, high: 7 });
    expect(yOf(7, range, 100)).toBeGreaterThan(0);
    expect(yOf(-5, range, 100)).toBeLessThan(100);
    expect(rangeOf(aTile([]))).toBeUndefined();
    expect(rangeOf(aTile([[1, 3]]))).toEqual({ low: 2, high: 4 });
  });
});

it('ticks that are closer than can be seen are one', () => {
  const tile = aTile([10, 11, 12, 13, 50].map((timeMs) => [timeMs, 0]));
  expect([...tickColumns(piecesOf(tile), view)]).toEqual([10.5, 13.5, 50.5]);
});

describe('what was not read', () => {
  const drawn = (counts: Float32Array, pieces: readonly TilePiece[] = []) => {
    const bars: [number, number][] = [];
    const pen = { fillRect: (x: number, _y: number, _w: number, h: number) => bars.push([x, h]) };
    drawActivity(pen as unknown as Pen, { counts, durationMs: 100, readMs: 40 }, pieces, view);
    return bars;
  };
  const counts = Float32Array.from({ length: 10 }, (_, part) => (part < 5 ? 100 : 25));
  counts[6] = 0;

  it('is drawn from where the reading is, the more records the higher', () => {
    const bars = drawn(counts);
    expect(bars[0]).toEqual([40, 70]);
    expect(bars.filter(([x]) => x >= 60 && x < 70)).toEqual([]);
    expect(bars.filter(([x]) => x >= 70).every(([, height]) => height === 35)).toBe(true);
    expect(bars.at(-1)![0]).toBe(98);
  });

  it('leaves out stretches that were read before the rest, and parts that are too wide', () => {
    const piece = { tile: aTile([[81, 1]]), fromMs: 80, untilMs: 100 };
    expect(drawn(counts, [piece]).at(-1)![0]).toBe(78);
    expect(drawn(Float32Array.of(1, 1))).toEqual([]);
  });
});

describe('the film strip', () => {
  it('shows the first picture of each slot, and none where none came', () => {
    const frames = Float64Array.from([0, 4, 12, 51]);
    const slots = filmSlots(frames, view.span, 100, 20);
    expect(slots.map(({ frameMs }) => frameMs)).toEqual([0, undefined, 51, undefined, undefined]);
  });

  it('moves with its pictures when it is panned', () => {
    const frames = Float64Array.from({ length: 200 }, (_, index) => index);
    const before = filmSlots(frames, { fromMs: 40, untilMs: 140 }, 100, 20);
    const after = filmSlots(frames, { fromMs: 45, untilMs: 145 }, 100, 20);
    expect(after[1]).toEqual({ ...before[1], x: before[1]!.x - 5 });
  });
});

it('the usual text stands back when others are to be seen', () => {
  const run = (label: string, fromMs: number, untilMs: number): Run => ({
    label,
    fromMs,
    untilMs,
    lane: 0,
  });
  expect(quietLabels([run('rest', 0, 80), run('tap', 80, 90), run('swipe', 90, 100)])).toEqual(
    new Set(['rest']),
  );
  expect(quietLabels([run('on', 0, 80), run('off', 80, 100)]).size).toBe(0);
});
