import type { TopicRecord } from '@ubii/proto';
import { alignOutputs, type AlignOptions, type OutputPair } from './align-outputs.ts';
import { OutputQueue, type Output } from './output-queue.ts';

/** Where a run wrote something else than what was recorded. */
export interface OutputDifference {
  /** `missing`: only the recording has it; `additional`: only the run has it. */
  readonly kind: 'different' | 'missing' | 'additional';
  /** Moment of the recording, nanoseconds since the Unix epoch. */
  readonly timeNs: bigint;
  /** First member that differs, such as `position.x`; empty for the value itself. */
  readonly path: string;
  /** Undefined when there is none, or it has no value. */
  readonly recorded: TopicRecord | undefined;
  readonly rerun: TopicRecord | undefined;
}

/** How the outputs of one topic compare. */
export interface TopicComparison {
  /** Topic of the recording. */
  readonly topic: string;
  readonly same: number;
  readonly different: number;
  readonly missing: number;
  readonly additional: number;
  /** How many of the missing and additional ones come before the first pair or after the last one. */
  readonly atEdges: number;
  /** The first ones of each kind, in the order of time. */
  readonly differences: readonly OutputDifference[];
}

/** The outputs of a topic, and how they are compared. */
export interface TopicOptions extends AlignOptions {
  readonly topic: string;
  /** How many differences of each kind are listed. @default 20 */
  readonly maxDifferences?: number | undefined;
  /** Called for each pair; false leaves it out. */
  readonly onPair?: (pair: OutputPair) => boolean;
}

type Outputs = AsyncIterable<Output> | Iterable<Output>;

const MAX_DIFFERENCES = 20;

/** Compares the recorded outputs of one topic with those of a run, both in the order of time. */
export async function compareTopic(
  recorded: Outputs,
  rerun: Outputs,
  options: TopicOptions,
): Promise<TopicComparison> {
  const { topic, maxDifferences = MAX_DIFFERENCES, onPair } = options;
  const counts = { same: 0, different: 0, missing: 0, additional: 0 };
  const differences: OutputDifference[] = [];
  let atEdges = 0;
  let sincePair = 0;
  const pairs = alignOutputs(new OutputQueue(recorded), new OutputQueue(rerun), options);
  for await (const pair of pairs) {
    if (onPair?.(pair) === false) continue;
    const kind = kindOf(pair);
    const hadPair = counts.same + counts.different > 0;
    counts[kind] += 1;
    if (kind === 'missing' || kind === 'additional') {
      if (hadPair) sincePair += 1;
      else atEdges += 1;
    } else sincePair = 0;
    if (kind !== 'same' && counts[kind] <= maxDifferences)
      differences.push(differenceOf(kind, pair));
  }
  return { topic, ...counts, atEdges: atEdges + sincePair, differences };
}

function differenceOf(
  kind: OutputDifference['kind'],
  { recorded, rerun, path = '' }: OutputPair,
): OutputDifference {
  const { timeNs } = (recorded ?? rerun)!;
  return { kind, path, timeNs, recorded: recorded?.record, rerun: rerun?.record };
}

function kindOf({ recorded, rerun, path }: OutputPair): OutputDifference['kind'] | 'same' {
  if (rerun === undefined) return 'missing';
  if (recorded === undefined) return 'additional';
  return path === undefined ? 'same' : 'different';
}
