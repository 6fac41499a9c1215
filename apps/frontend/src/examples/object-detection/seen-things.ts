import type { PlaneShape } from '../../topics/viewers/plane/plane-shapes.ts';

/** Something in the picture now. */
export interface SeenThing {
  readonly key: string;
  readonly name: string;
  readonly letter: string | undefined;
  /** 0 to 1. */
  readonly score: number;
  readonly isBelow: boolean;
}

/** Lowest score of things below the threshold that are listed, and the most of them. */
const LEAST_SCORE = 0.2;
const MAX_BELOW = 4;

/**
 * What is seen, the highest score first, and then what falls below the threshold.
 * @param above as drawn
 * @param below of the same picture
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
      .filter(({ score }) => score >= LEAST_SCORE)
      .sort(byScore)
      .slice(0, MAX_BELOW),
  ];
}
