import { findDifference } from './value-difference.ts';
import type { Output, TopicOutputs } from './topic-outputs.ts';

/** Outputs that belong together; one is missing where only the other side has an output. */
export interface OutputPair {
  readonly recorded: Output | undefined;
  readonly rerun: Output | undefined;
  /** First member that differs, empty for the value itself; undefined when they are the same or one is missing. */
  readonly path: string | undefined;
}

interface Tolerances {
  readonly toleranceNs: bigint;
  readonly relativeTolerance: number;
}

/** So many outputs are looked ahead for one that is the same. */
const LOOK_AHEAD = 8;

/**
 * Pairs the outputs of a topic in their order: those with the same value near in time, else those nearest in time. An output that
 * repeats the value which the other side has just before or after is the same: a module that runs at a frequency samples a change
 * one round earlier or later.
 */
export async function* alignOutputs(
  recorded: TopicOutputs,
  rerun: TopicOutputs,
  tolerances: Tolerances,
): AsyncGenerator<OutputPair> {
  let before: Sides = { here: undefined, there: undefined };
  for (;;) {
    const here = await recorded.peek(LOOK_AHEAD);
    const there = await rerun.peek(LOOK_AHEAD);
    if (here.length === 0 && there.length === 0) return;
    const [skipHere, skipThere] = nextStep(here, there, tolerances);
    for (let place = 0; place < Math.max(skipHere, skipThere); place += 1) {
      const a = place < skipHere ? here[place] : undefined;
      const b = place < skipThere ? there[place] : undefined;
      const around = (side: readonly Output[], last: Output | undefined, skip: number) => {
        const at = Math.min(place, skip);
        return [at === 0 ? last : side[at - 1], side[at], side[at + 1]];
      };
      const isRepeated =
        repeats(a, around(there, before.there, skipThere), tolerances) &&
        repeats(b, around(here, before.here, skipHere), tolerances);
      yield isRepeated
        ? { recorded: a ?? b, rerun: b ?? a, path: undefined }
        : { recorded: a, rerun: b, path: a && b && differenceOf(a, b, tolerances) };
    }
    before = {
      here: here[skipHere - 1] ?? before.here,
      there: there[skipThere - 1] ?? before.there,
    };
    recorded.skip(skipHere);
    rerun.skip(skipThere);
  }
}

/** The last outputs that were paired. */
interface Sides {
  readonly here: Output | undefined;
  readonly there: Output | undefined;
}

/** Whether an output, if there is one, is one of those of the other side. */
function repeats(
  output: Output | undefined,
  others: readonly (Output | undefined)[],
  tolerances: Tolerances,
): boolean {
  return (
    output === undefined ||
    others.some((other) => other !== undefined && areSame(output, other, tolerances))
  );
}

/** How many outputs of each side come next: one of each as a pair, or those before the next pair with the same value. */
function nextStep(
  here: readonly Output[],
  there: readonly Output[],
  tolerances: Tolerances,
): readonly [number, number] {
  const [a, b] = [here[0], there[0]];
  if (a === undefined) return [0, 1];
  if (b === undefined) return [1, 0];
  if (!areNear(a, b, tolerances)) return a.timeNs < b.timeNs ? [1, 0] : [0, 1];
  if (differenceOf(a, b, tolerances) === undefined) return [1, 1];
  return findSame(here, there, tolerances) ?? nearestStep(here, there);
}

/** Finds the nearest pair with the same value. Skipping as many outputs of both sides is preferred. */
function findSame(
  here: readonly Output[],
  there: readonly Output[],
  tolerances: Tolerances,
): readonly [number, number] | undefined {
  const isSame = (i: number, j: number): boolean => {
    const [a, b] = [here[i], there[j]];
    return a !== undefined && b !== undefined && areSame(a, b, tolerances);
  };
  for (let far = 1; far < LOOK_AHEAD; far += 1) {
    for (let near = far; near >= 0; near -= 1) {
      if (isSame(far, near)) return [far, near];
      if (isSame(near, far)) return [near, far];
    }
  }
  return undefined;
}

/** Leaves an output alone when the one after it is nearer to that of the other side. */
function nearestStep(here: readonly Output[], there: readonly Output[]): readonly [number, number] {
  const [a, nextA] = here;
  const [b, nextB] = there;
  const apart = distance(a!, b!);
  if (nextA && distance(nextA, b!) < apart && !(nextB && distance(nextA, nextB) < apart))
    return [1, 0];
  if (nextB && distance(a!, nextB) < apart && !(nextA && distance(nextA, nextB) < apart))
    return [0, 1];
  return [1, 1];
}

function distance(a: Output, b: Output): bigint {
  return a.timeNs > b.timeNs ? a.timeNs - b.timeNs : b.timeNs - a.timeNs;
}

const areNear = (a: Output, b: Output, { toleranceNs }: Tolerances): boolean =>
  distance(a, b) <= toleranceNs;

const areSame = (a: Output, b: Output, tolerances: Tolerances): boolean =>
  areNear(a, b, tolerances) && differenceOf(a, b, tolerances) === undefined;

function differenceOf(a: Output, b: Output, { relativeTolerance }: Tolerances): string | undefined {
  if (a.record?.format !== b.record?.format) return '';
  return findDifference(a.record?.value, b.record?.value, relativeTolerance);
}
