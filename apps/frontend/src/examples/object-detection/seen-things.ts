import type { PlaneShape } from '../../topics/viewers/plane/plane-shapes.ts';

/** Object in the current picture. */
export interface SeenThing {
  readonly key: string;
  readonly name: string;
  readonly letter: string | undefined;
  /** 0 to 1. */
  readonly score: number;
  readonly isBelow: boolean;
}

/** Limits for listed objects below the threshold: lowest score, and number. */
const MIN_SCORE = 0.2;
const MAX_BELOW = 4;

/**
 * Returns detected objects by descending score, followed by those below the threshold.
 * @param above objects that are drawn
 * @param below objects below the threshold in the same picture
 */
export function seenThings(
  above: readonly PlaneShape[],
  below: readonly PlaneShape[],
): readonly SeenThing[] {
  const thing = ({ key, name, letter, score = 0 }: PlaneShape, isBelow: boolean): SeenThing => ({
    key: isBelow ? `below ${key}` : key,
    name,
    letter,
    score,
    isBelow,
  });
  const byScore = (a: SeenThing, b: SeenThing): number => b.score - a.score;
  return [
    ...above.map((shape) => thing(shape, false)).sort(byScore),
    ...below
      .map((shape) => thing(shape, true))
      .filter(({ score }) => score >= MIN_SCORE)
      .sort(byScore)
      .slice(0, MAX_BELOW),
  ];
}
