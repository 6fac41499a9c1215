import type { JsonValue } from '@ubii/proto';
import type { CaseRecord } from './module-case.ts';

/** Outputs on one topic, recorded and of this run. */
export interface TopicOutputs {
  readonly topic: string;
  readonly matched: number;
  readonly different: number;
  /** Recorded outputs without one of this run. */
  readonly missing: number;
  /** Outputs of this run without a recorded one. */
  readonly additional: number;
  readonly first: OutputDifference | undefined;
}

/** Two outputs that differ. */
export interface OutputDifference {
  /** Of the recorded output, milliseconds since the beginning of the case. */
  readonly atMs: number;
  /** Such as `vector2.x`. */
  readonly path: string;
  readonly recorded: JsonValue | undefined;
  readonly now: JsonValue | undefined;
}

/** So many outputs at the edges of a span may have their cause outside of it, or their effect. */
export const EDGE_OUTPUTS = 3;

/** How exactly outputs are compared. */
export interface Exactness {
  /** Numbers are the same when they differ by at most this share of the larger one, or of 1. */
  readonly tolerance: number;
  /**
   * For modules that run at a rhythm, whose phase is not recorded: outputs may be so much earlier or later. Undefined for
   * modules that inputs trigger, whose outputs are the same one by one.
   */
  readonly windowMs?: number | undefined;
  /** Length of the case: what belongs to an output near its end may be after it. */
  readonly durationMs: number;
}

/** Compares recorded outputs with those of a run, topic by topic in the order of time. */
export function compareCaseOutputs(
  recorded: readonly CaseRecord[],
  run: readonly CaseRecord[],
  exactness: Exactness,
): TopicOutputs[] {
  const topics = new Set([...recorded, ...run].map(({ topic }) => topic));
  return [...topics].map((topic) => {
    const on = (all: readonly CaseRecord[]) => all.filter((one) => one.topic === topic);
    return exactness.windowMs === undefined
      ? bestShift(topic, on(recorded), on(run), exactness)
      : compareNear(topic, on(recorded), on(run), { ...exactness, windowMs: exactness.windowMs });
  });
}

/** Whether outputs are as recorded, apart from those at the edges. */
export function isSame({ matched, different, missing, additional }: TopicOutputs): boolean {
  return different === 0 && matched > 0 && missing + additional <= EDGE_OUTPUTS;
}

function bestShift(
  topic: string,
  recorded: readonly CaseRecord[],
  run: readonly CaseRecord[],
  exactness: Exactness,
): TopicOutputs {
  const shifts = [0, ...Array.from({ length: EDGE_OUTPUTS }, (_, i) => [i + 1, -i - 1])].flat();
  const tried = shifts.map((shift) => compareShifted(topic, recorded, run, shift, exactness));
  return tried.reduce((best, one) => (errors(one) < errors(best) ? one : best));
}

const errors = ({ different, missing, additional }: TopicOutputs): number =>
  different + missing + additional;

function compareShifted(
  topic: string,
  recorded: readonly CaseRecord[],
  run: readonly CaseRecord[],
  shift: number,
  { tolerance }: Exactness,
): TopicOutputs {
  let matched = 0;
  const differences: OutputDifference[] = [];
  for (const [index, { atMs, record }] of recorded.entries()) {
    const other = run[index + shift];
    if (other === undefined) continue;
    const difference = differenceOf(record, other.record, tolerance);
    if (difference === undefined) matched += 1;
    else differences.push({ atMs, ...difference });
  }
  const pairs = matched + differences.length;
  return {
    topic,
    matched,
    different: differences.length,
    missing: recorded.length - pairs,
    additional: run.length - pairs,
    first: differences[0],
  };
}

/** Looks for the same value near in time. */
function compareNear(
  topic: string,
  recorded: readonly CaseRecord[],
  run: readonly CaseRecord[],
  { tolerance, windowMs, durationMs }: Exactness & { readonly windowMs: number },
): TopicOutputs {
  const near = (all: readonly CaseRecord[], { atMs }: CaseRecord): readonly CaseRecord[] =>
    all.filter((one) => Math.abs(one.atMs - atMs) <= windowMs);
  let matched = 0;
  let missing = 0;
  const differences: OutputDifference[] = [];
  for (const one of recorded) {
    const found = near(run, one).map((other) => differenceOf(one.record, other.record, tolerance));
    const [difference] = found;
    if (found.includes(undefined)) matched += 1;
    else if (difference === undefined || one.atMs + windowMs > durationMs) missing += 1;
    else differences.push({ atMs: one.atMs, ...difference });
  }
  const additional = run.filter((one) => near(recorded, one).length === 0).length;
  const [first] = differences;
  return { topic, matched, different: differences.length, missing, additional, first };
}

type Difference = Omit<OutputDifference, 'atMs'>;

/** Where two values differ first. Members that are not written have their default. */
function differenceOf(
  recorded: JsonValue | undefined,
  now: JsonValue | undefined,
  tolerance: number,
  path = '',
): Difference | undefined {
  if (recorded === now) return undefined;
  if (isMembers(recorded) || isMembers(now)) {
    const [a, b] = [membersOf(recorded), membersOf(now)];
    for (const key of new Set([...Object.keys(a), ...Object.keys(b)])) {
      const inner = path === '' ? key : `${path}.${key}`;
      const found = differenceOf(a[key], b[key], tolerance, inner);
      if (found) return found;
    }
    return undefined;
  }
  const [a, b] = [orDefault(recorded, now), orDefault(now, recorded)];
  if (typeof a === 'number' && typeof b === 'number') {
    const larger = Math.max(1, Math.abs(a), Math.abs(b));
    if (Math.abs(a - b) <= tolerance * larger) return undefined;
  }
  return a === b ? undefined : { path, recorded, now };
}

type Members = Readonly<Record<string, JsonValue | undefined>>;
const isMembers = (value: JsonValue | undefined): boolean =>
  typeof value === 'object' && value !== null;
const membersOf = (value: JsonValue | undefined): Members =>
  isMembers(value) ? (value as Members) : {};

const DEFAULTS: Readonly<Record<string, JsonValue>> = { number: 0, string: '', boolean: false };
const orDefault = (
  value: JsonValue | undefined,
  other: JsonValue | undefined,
): JsonValue | undefined => value ?? DEFAULTS[typeof other];
