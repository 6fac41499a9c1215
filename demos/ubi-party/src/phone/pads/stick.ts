/** A direction: right and away from the player are positive, each from -1 to 1. */
export interface Steering {
  readonly x: number;
  readonly y: number;
}

/** On the page, CSS pixels, downwards. */
export interface PagePoint {
  readonly x: number;
  readonly y: number;
}

export interface PageBox extends PagePoint {
  readonly width: number;
  readonly height: number;
}

export const STRAIGHT: Steering = { x: 0, y: 0 };

/** A thumb that rests is never quite still. */
const DEAD_ZONE = 0.12;
/** The origin follows a thumb that goes further than this, so that turning back answers at once. */
const LEASH = 1.25;

/**
 * @param origin where the thumb came down
 * @param travelPx how far the thumb goes for a full deflection
 * @returns length 0 to 1: 0 inside the dead zone, growing from 0 at its edge
 */
export function stickAt(origin: PagePoint, thumb: PagePoint, travelPx: number): Steering {
  const x = (thumb.x - origin.x) / travelPx;
  const y = (origin.y - thumb.y) / travelPx;
  const length = Math.hypot(x, y);
  if (length <= DEAD_ZONE) return STRAIGHT;
  const scale = withoutDeadZone(Math.min(1, length), DEAD_ZONE) / length;
  return { x: x * scale, y: y * scale };
}

/** The wheel under a thumb: sideways only. */
export function wheelAt(origin: PagePoint, thumb: PagePoint, travelPx: number): Steering {
  return { x: steered((thumb.x - origin.x) / travelPx, DEAD_ZONE / 2), y: 0 };
}

/** The origin after the thumb has moved. */
export function leashed(origin: PagePoint, thumb: PagePoint, travelPx: number): PagePoint {
  const x = thumb.x - origin.x;
  const y = thumb.y - origin.y;
  const over = Math.hypot(x, y) / (travelPx * LEASH);
  if (over <= 1) return origin;
  return { x: thumb.x - x / over, y: thumb.y - y / over };
}

/** The nearest point inside a box, so far from its edges; the middle of a box that is too small for that. */
export function inside(box: PageBox, point: PagePoint, insetPx: number): PagePoint {
  const nearest = (value: number, from: number, size: number): number => {
    const inset = Math.min(insetPx, size / 2);
    return Math.min(from + size - inset, Math.max(from + inset, value));
  };
  return { x: nearest(point.x, box.x, box.width), y: nearest(point.y, box.y, box.height) };
}

/** One axis: clamped to -1 to 1, 0 inside the dead zone, growing from 0 at its edge. */
export function steered(value: number, deadZone: number): number {
  const size = Math.min(1, Math.abs(value));
  return size <= deadZone ? 0 : Math.sign(value) * withoutDeadZone(size, deadZone);
}

function withoutDeadZone(size: number, deadZone: number): number {
  return (size - deadZone) / (1 - deadZone);
}
