import type { BoardCorner } from './board-detector.ts';
import type { Vector3Value } from './rotations.ts';

/** A picture of the board that counts for a calibration. */
export interface CalibrationView {
  readonly corners: readonly BoardCorner[];
  /** Direction out of the board, towards the camera; length 1, the frame of `MarkerPose`. */
  readonly normal: Vector3Value;
}

/** Views that make a calibration. */
export const WANTED_VIEWS = 12;
/** Corners that a view has at least. */
export const MIN_CORNERS = 8;
/** Mean movement of corners from which a view is a new one, as a share of the picture's diagonal. */
const OTHER_VIEW = 0.06;
/** Cosine of how far a board has turned in a view that is another one: 12 degrees. */
const OTHER_TURN = 0.978;
/** Largest movement between two pictures of a board that is held still, as a share of the diagonal. */
const STILL = 0.006;
/** Sine of the tilt that counts as one: 15 degrees. */
const TILTED = 0.26;
/** A part of the picture within which corners are at its edge. */
const EDGE = 0.2;

interface Size {
  readonly width: number;
  readonly height: number;
}

/** Whether the board moved little since the picture before. */
export function isStill(
  now: readonly BoardCorner[],
  before: readonly BoardCorner[],
  size: Size,
): boolean {
  return movement(now, before, size) < STILL;
}

/** Whether a view shows what no other one does: the board elsewhere, or tilted in another way. */
export function isNewView(
  view: CalibrationView,
  views: readonly CalibrationView[],
  size: Size,
): boolean {
  const { normal, corners } = view;
  return views.every((one) => {
    const cosine = normal.x * one.normal.x + normal.y * one.normal.y + normal.z * one.normal.z;
    return cosine < OTHER_TURN || movement(corners, one.corners, size) > OTHER_VIEW;
  });
}

/** Next step for the user, one sentence: the kind of view that is missing. Sides are those of the picture. */
export function nextHint(views: readonly CalibrationView[], { width, height }: Size): string {
  const hasTilt = (test: (normal: Vector3Value) => boolean): boolean =>
    views.some(({ normal }) => test(normal));
  const hasPlace = (test: (x: number, y: number) => boolean): boolean =>
    views.some(({ corners }) => corners.some(({ x, y }) => test(x / width, y / height)));
  const wishes: readonly (readonly [isThere: boolean, hint: string])[] = [
    [views.length > 0, 'Hold the board straight in front of the camera.'],
    [hasTilt(({ x }) => x < -TILTED), 'Turn the left side of the board away from the camera.'],
    [hasTilt(({ x }) => x > TILTED), 'Turn the right side of the board away from the camera.'],
    [hasTilt(({ y }) => y > TILTED), 'Tilt the top of the board away from the camera.'],
    [hasTilt(({ y }) => y < -TILTED), 'Tilt the bottom of the board away from the camera.'],
    [hasPlace((x) => x < EDGE), 'Move the board to the left edge of the picture.'],
    [hasPlace((x) => x > 1 - EDGE), 'Move the board to the right edge of the picture.'],
    [hasPlace((_x, y) => y < EDGE), 'Move the board to the top of the picture.'],
    [hasPlace((_x, y) => y > 1 - EDGE), 'Move the board to the bottom of the picture.'],
  ];
  const missing = wishes.find(([isThere]) => !isThere);
  return missing?.[1] ?? 'Move the board nearer or further away, and tilt it.';
}

/** Mean distance of the corners that both have, as a part of the diagonal; infinite when there are too few. */
function movement(
  now: readonly BoardCorner[],
  before: readonly BoardCorner[],
  { width, height }: Size,
): number {
  const places = new Map(before.map((corner) => [corner.id, corner]));
  const distances = now.flatMap(({ id, x, y }) => {
    const other = places.get(id);
    return other === undefined ? [] : [Math.hypot(x - other.x, y - other.y)];
  });
  if (distances.length < MIN_CORNERS / 2) return Infinity;
  const sum = distances.reduce((total, one) => total + one, 0);
  return sum / distances.length / Math.hypot(width, height);
}
