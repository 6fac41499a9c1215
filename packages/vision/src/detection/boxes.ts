import type { Box, Detection } from './detector.ts';

/** Returns the box between two corners, cut at the borders of the picture. */
export function boxBetween(left: number, top: number, right: number, bottom: number): Box {
  const inside = (value: number): number => Math.min(1, Math.max(0, value));
  const [x, y] = [inside(left), inside(top)];
  return { x, y, width: Math.max(0, inside(right) - x), height: Math.max(0, inside(bottom) - y) };
}

/** Returns how much two boxes cover each other: the area of both over that of either, 0 to 1. */
export function overlap(a: Box, b: Box): number {
  const width = Math.min(a.x + a.width, b.x + b.width) - Math.max(a.x, b.x);
  const height = Math.min(a.y + a.height, b.y + b.height) - Math.max(a.y, b.y);
  const both = Math.max(0, width) * Math.max(0, height);
  const either = a.width * a.height + b.width * b.height - both;
  return either > 0 ? both / either : 0;
}

/**
 * Returns detections without those that a better one of the same class covers.
 *
 * @param detections the highest score first
 * @param maxOverlap from which overlap on two boxes are one object
 * @param maxObjects most to return
 */
export function withoutCovered(
  detections: readonly Detection[],
  maxOverlap: number,
  maxObjects: number,
): Detection[] {
  const kept: Detection[] = [];
  for (const detection of detections) {
    if (kept.length === maxObjects) break;
    const isCovered = kept.some(
      (better) =>
        better.class === detection.class && overlap(better.box, detection.box) > maxOverlap,
    );
    if (!isCovered) kept.push(detection);
  }
  return kept;
}
