import { SeriesRing, type LinePoints } from '../../history/series-ring.ts';

/** Creates a line with these points. */
export function aLine(points: readonly (readonly [timeMs: number, value: number])[]): LinePoints {
  const ring = new SeriesRing(1, 100_000);
  for (const [timeMs, value] of points) ring.push(timeMs, [value]);
  return ring.line(0);
}
