import { StudyOrder } from '@ubii/proto';

/**
 * Returns a generator of numbers from 0 to below 1, the same numbers for the same seed in every version of the master.
 *
 * Sources: FNV-1a, http://www.isthe.com/chongo/tech/comp/fnv; mulberry32 by Tommy Ettinger, public domain.
 */
function createRandom(seed: string): () => number {
  let state = 0x811c9dc5;
  for (let index = 0; index < seed.length; index++) {
    state = Math.imul(state ^ seed.charCodeAt(index), 0x01000193);
  }
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** Whose order it is. */
export interface OrderSubject {
  readonly studyId: string;
  /** Number of the participant, from 1. */
  readonly number: number;
  readonly visit: string;
}

/**
 * The order of conditions of one repetition. [ST-10]
 * @param count number of conditions
 * @param repetition from 1
 * @returns indices of conditions
 */
export function orderOfConditions(
  order: StudyOrder,
  count: number,
  repetition: number,
  { studyId, number, visit }: OrderSubject,
): number[] {
  if (order === StudyOrder.STUDY_ORDER_BALANCED) {
    const rows = williamsDesign(count);
    return [...rows[(number - 1) % rows.length]!];
  }
  const indices = Array.from({ length: count }, (_, index) => index);
  if (order !== StudyOrder.STUDY_ORDER_RANDOM) return indices;
  return shuffled(indices, createRandom(`${studyId} ${number} ${visit} ${repetition}`));
}

/**
 * Rows of a Williams design: a Latin square, or two for an odd number, in which each number follows each other one
 * equally often.
 *
 * Source: E. J. Williams, Experimental designs balanced for the estimation of residual effects of treatments, Australian Journal
 * of Scientific Research A 2 (1949), 149–168.
 */
export function williamsDesign(count: number): number[][] {
  const first = Array.from({ length: count }, (_, index) =>
    index % 2 === 1 ? (index + 1) / 2 : (count - index / 2) % count,
  );
  return Array.from({ length: count }, (_, shift) => shift).flatMap((shift) => {
    const row = first.map((each) => (each + shift) % count);
    return count % 2 === 0 || count === 1 ? [row] : [row, [...row].reverse()];
  });
}

/** Fisher–Yates. */
function shuffled(list: readonly number[], random: () => number): number[] {
  const result = [...list];
  for (let last = result.length - 1; last > 0; last--) {
    const other = Math.floor(random() * (last + 1));
    [result[last], result[other]] = [result[other]!, result[last]!];
  }
  return result;
}
