import type { Output, OutputQueue } from './output-queue.ts';

/** Which numbers are the same: those within either tolerance. */
interface ValueTolerance {
  /** Of the larger of two numbers; 0 for exactly equal ones. */
  readonly relativeTolerance: number;
  readonly absoluteTolerance: number;
}

/**
 * Finds the first member in which two decoded values differ.
 *
 * @returns its path, such as `position.x`, `elements.0.id`, or empty for the value itself; undefined when they are the same
 */
function findDifference(a: unknown, b: unknown, tolerance: ValueTolerance): string | undefined {
  if (a === b) return undefined;
  if (typeof a === 'number' && typeof b === 'number')
    return areClose(a, b, tolerance) ? undefined : '';
  if (!isObject(a) || !isObject(b)) return '';
  if (ArrayBuffer.isView(a) || ArrayBuffer.isView(b)) return haveSameBytes(a, b) ? undefined : '';
  const members = new Set([...Object.keys(a), ...Object.keys(b)]);
  for (const member of members) {
    const path = findDifference(a[member], b[member], tolerance);
    if (path !== undefined) return path === '' ? member : `${member}.${path}`;
  }
  return undefined;
}

function areClose(a: number, b: number, tolerance: ValueTolerance): boolean {
  if (Number.isNaN(a) && Number.isNaN(b)) return true;
  const { relativeTolerance, absoluteTolerance } = tolerance;
  const larger = Math.max(Math.abs(a), Math.abs(b));
  if (!Number.isFinite(larger)) return false;
  return Math.abs(a - b) <= Math.max(absoluteTolerance, relativeTolerance * larger);
}

const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null;

function haveSameBytes(a: unknown, b: unknown): boolean {
  if (!(a instanceof Uint8Array) || !(b instanceof Uint8Array) || a.length !== b.length)
    return false;
  return a.every((byte, place) => byte === b[place]);
}

/** Outputs that belong together; one is missing where only the other side has an output. */
export interface OutputPair {
  readonly recorded: Output | undefined;
  readonly rerun: Output | undefined;
  /** First member that differs, empty for the value itself; undefined when they are the same or one is missing. */
  readonly path: string | undefined;
}

/** Which outputs are the same, and which belong together. */
export interface AlignOptions extends ValueTolerance {
  /** Outputs further apart do not belong together, nanoseconds. Undefined: their order counts, and times do not. */
  readonly toleranceNs: bigint | undefined;
  /**
   * Modules that run at a rhythm sample a change some rounds earlier or later: an output that repeats a value which the other
   * side has within the tolerance is the same.
   */
  readonly isSampled: boolean;
}

/** So many outputs are looked ahead for one that is the same, and back for one that is repeated. */
const LOOK_AHEAD = 8;

/** Pairs the outputs of a topic in their order: those with the same value, else those nearest in time. */
export async function* alignOutputs(
  recorded: OutputQueue,
  rerun: OutputQueue,
  options: AlignOptions,
): AsyncGenerator<OutputPair> {
  for (;;) {
    const here = await recorded.peek(LOOK_AHEAD);
    const there = await rerun.peek(LOOK_AHEAD);
    if (here.length === 0 && there.length === 0) return;
    const [skipHere, skipThere] = nextStep(here, there, options);
    for (let place = 0; place < Math.max(skipHere, skipThere); place += 1) {
      const a = place < skipHere ? here[place] : undefined;
      const b = place < skipThere ? there[place] : undefined;
      const isRepeated =
        options.isSampled &&
        repeats(a, [...rerun.past, ...there], options) &&
        repeats(b, [...recorded.past, ...here], options);
      yield isRepeated
        ? { recorded: a ?? b, rerun: b ?? a, path: undefined }
        : { recorded: a, rerun: b, path: a && b && differenceOf(a, b, options) };
    }
    recorded.skip(skipHere, LOOK_AHEAD);
    rerun.skip(skipThere, LOOK_AHEAD);
  }
}

/** Whether an output, if there is one, is one of those of the other side. */
function repeats(
  output: Output | undefined,
  others: readonly Output[],
  options: AlignOptions,
): boolean {
  return output === undefined || others.some((other) => areSame(output, other, options));
}

/** How many outputs of each side come next: one of each as a pair, or those before the next pair with the same value. */
function nextStep(
  here: readonly Output[],
  there: readonly Output[],
  options: AlignOptions,
): readonly [number, number] {
  const [a, b] = [here[0], there[0]];
  if (a === undefined) return [0, 1];
  if (b === undefined) return [1, 0];
  if (!areNear(a, b, options)) return a.timeNs < b.timeNs ? [1, 0] : [0, 1];
  if (differenceOf(a, b, options) === undefined) return [1, 1];
  const found = findSame(here, there, options);
  if (found !== undefined) return found;
  return options.toleranceNs === undefined ? [1, 1] : nearestStep(here, there);
}

/** Finds the nearest pair with the same value. Skipping as many outputs of both sides is preferred. */
function findSame(
  here: readonly Output[],
  there: readonly Output[],
  options: AlignOptions,
): readonly [number, number] | undefined {
  const isSame = (i: number, j: number): boolean => {
    const [a, b] = [here[i], there[j]];
    return a !== undefined && b !== undefined && areSame(a, b, options);
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

const areNear = (a: Output, b: Output, { toleranceNs }: AlignOptions): boolean =>
  toleranceNs === undefined || distance(a, b) <= toleranceNs;

const areSame = (a: Output, b: Output, options: AlignOptions): boolean =>
  areNear(a, b, options) && differenceOf(a, b, options) === undefined;

function differenceOf(a: Output, b: Output, tolerance: ValueTolerance): string | undefined {
  if (a.record?.format !== b.record?.format) return '';
  return findDifference(a.record?.value, b.record?.value, tolerance);
}
