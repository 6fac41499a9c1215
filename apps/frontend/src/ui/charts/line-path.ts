/** Point in pixels; a gap without y. */
export interface PathPoint {
  readonly x: number;
  readonly y: number | undefined;
}

/** Returns an SVG path through the points, with gaps, rounded to a tenth of a pixel. */
export function linePath(points: readonly PathPoint[]): string {
  let path = '';
  let isDrawing = false;
  for (const { x, y } of points) {
    if (y === undefined) {
      isDrawing = false;
      continue;
    }
    path += `${isDrawing ? 'L' : 'M'}${x.toFixed(1)} ${y.toFixed(1)}`;
    isDrawing = true;
  }
  return path;
}
