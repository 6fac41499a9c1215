import { decodeRecord } from '@ubii/proto';
import { compareTopic, type Output, type TopicComparison } from '@ubii/recording/compare';
import { encodeCaseRecord, type CaseRecord } from './module-case.ts';

/** Outputs at the edges of a span may have their cause outside of it, or their effect: so many are accepted. */
export const EDGE_OUTPUTS = 3;

/** An output of a run. */
export interface CaseOutput extends Output {
  readonly topic: string;
}

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

const NS_PER_MS = 1_000_000;

/** @param atMs since the beginning of the case */
export const caseTimeNs = (atMs: number): bigint => BigInt(Math.round(atMs * NS_PER_MS));
/** Milliseconds since the beginning of the case. */
export const caseTimeMs = (timeNs: bigint): number => Number(timeNs) / NS_PER_MS;

/**
 * Compares recorded outputs with those of a run, topic by topic in the order of time.
 *
 * @throws Error with a sentence when a recorded output cannot be read
 */
export function compareCaseOutputs(
  recorded: readonly CaseRecord[],
  run: readonly CaseOutput[],
  exactness: Exactness,
): Promise<TopicComparison[]> {
  const outputs = recorded.map(toOutput);
  const topics = new Set([...outputs, ...run].map(({ topic }) => topic));
  return Promise.all(
    [...topics].map((topic) => {
      const on = (all: readonly CaseOutput[]) => all.filter((one) => one.topic === topic);
      return compareOn(topic, on(outputs), on(run), exactness);
    }),
  );
}

/** Whether outputs are as recorded, apart from those at the edges. */
export function isSame({
  same,
  different,
  missing,
  additional,
  atEdges,
}: TopicComparison): boolean {
  return different === 0 && same > 0 && missing + additional === atEdges && atEdges <= EDGE_OUTPUTS;
}

/** Returns the best comparison among those in which one side begins some outputs later. */
async function compareOn(
  topic: string,
  recorded: readonly CaseOutput[],
  run: readonly CaseOutput[],
  exactness: Exactness,
): Promise<TopicComparison> {
  const { windowMs } = exactness;
  const compare = (shift: number) => compareShifted(topic, recorded, run, shift, exactness);
  let best = await compare(0);
  if (windowMs !== undefined) return { ...best, atEdges: best.missing + best.additional };
  for (let shift = 1; shift <= EDGE_OUTPUTS && !isSame(best); shift += 1) {
    for (const other of [await compare(shift), await compare(-shift)])
      if (errors(other) < errors(best)) best = other;
  }
  return best;
}

/** Those at the edges are no error as long as nothing else is. */
const errors = ({ different, missing, additional, atEdges }: TopicComparison): number =>
  2 * (different + missing + additional) - atEdges;

/** @param shift how many outputs at the beginning are of the run only; negative: of the recording only */
async function compareShifted(
  topic: string,
  recorded: readonly CaseOutput[],
  run: readonly CaseOutput[],
  shift: number,
  { tolerance, windowMs, durationMs }: Exactness,
): Promise<TopicComparison> {
  const [early, late] = [recorded.slice(0, Math.max(0, -shift)), run.slice(0, Math.max(0, shift))];
  const untilNs = caseTimeNs(durationMs - (windowMs ?? 0));
  let afterEnd = 0;
  const compared = await compareTopic(recorded.slice(early.length), run.slice(late.length), {
    topic,
    relativeTolerance: tolerance,
    absoluteTolerance: tolerance,
    maxDifferences: 1,
    toleranceNs: windowMs === undefined ? undefined : caseTimeNs(windowMs),
    isSampled: windowMs !== undefined,
    onPair({ recorded: one, rerun, path }) {
      const isOpen = windowMs !== undefined && one !== undefined && one.timeNs > untilNs;
      if (!isOpen || rerun === undefined || path === undefined) return true;
      afterEnd += 1;
      return false;
    },
  });
  const { missing, additional, atEdges } = compared;
  return {
    ...compared,
    missing: missing + early.length + afterEnd,
    additional: additional + late.length,
    atEdges: atEdges + early.length + late.length + afterEnd,
  };
}

function toOutput(record: CaseRecord): CaseOutput {
  const decoded = decodeRecord(encodeCaseRecord(record));
  return {
    topic: record.topic,
    timeNs: caseTimeNs(record.atMs),
    record: decoded.format === undefined ? undefined : decoded,
  };
}
