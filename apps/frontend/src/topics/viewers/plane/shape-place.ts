import type { Area } from './place-labels.ts';
import type { PlaneShape } from './plane-shapes.ts';

/** Conversion from coordinates of shapes to coordinates of an SVG. */
export interface PlaneScale {
  readonly scaleX: (x: number) => number;
  readonly scaleY: (y: number) => number;
}

/** Returns the rectangle of a shape in the SVG; of size 0 for a point. */
export function placeOf({ x, y, size }: PlaneShape, { scaleX, scaleY }: PlaneScale): Area {
  const [left, top] = [scaleX(x), scaleY(y)];
  const right = scaleX(x + (size?.width ?? 0));
  const bottom = scaleY(y + (size?.height ?? 0));
  return {
    x: Math.min(left, right),
    y: Math.min(top, bottom),
    width: Math.abs(right - left),
    height: Math.abs(bottom - top),
  };
}
