import type { Area } from './place-labels.ts';
import type { PlaneShape } from './plane-shapes.ts';

/** From places of shapes to places of an SVG. */
export interface PlaneScale {
  readonly scaleX: (x: number) => number;
  readonly scaleY: (y: number) => number;
}

/** Where a shape lies in the SVG; a point has no width and height. */
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
