import { BODY_BONES } from '@ubii/vision/body-keypoints';
import { HAND_BONES } from '@ubii/vision/hand-keypoints';
import type { PlaneShape } from './plane-shapes.ts';

/** Two connected keypoints. */
export type Bone = readonly [from: PlaneShape, to: PlaneShape];

const BONES: readonly (readonly [string, string])[] = [
  ...BODY_BONES,
  ...['left', 'right'].flatMap((side) =>
    HAND_BONES.map(([from, to]) => [`${side}.${from}`, `${side}.${to}`] as const),
  ),
];
const KEYPOINTS: ReadonlySet<string> = new Set(BONES.flat());

/** True for a keypoint of a body or a hand, by its name. */
export const isKeypoint = ({ name, size }: PlaneShape): boolean =>
  size === undefined && KEYPOINTS.has(name);

/** Score below which keypoints are uncertain: hidden, or outside of the picture. */
const SEEN_SCORE = 0.5;

/** True for an uncertain keypoint of a body or a hand. */
export const isGuessed = (shape: PlaneShape): boolean =>
  isKeypoint(shape) && shape.score !== undefined && shape.score < SEEN_SCORE;

/** Returns the bones of all bodies and hands; a repeated name starts the next body or hand. */
export function bonesOf(shapes: readonly PlaneShape[]): Bone[] {
  const bones: Bone[] = [];
  let points = new Map<string, PlaneShape>();
  const close = (): void => {
    if (points.size < 2) return;
    for (const [first, second] of BONES) {
      const [from, to] = [points.get(first), points.get(second)];
      if (from && to) bones.push([from, to]);
    }
  };
  for (const shape of shapes) {
    if (!isKeypoint(shape)) continue;
    if (points.has(shape.name)) {
      close();
      points = new Map();
    }
    points.set(shape.name, shape);
  }
  close();
  return bones;
}
