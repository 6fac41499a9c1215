import type { TopicRecord } from '@ubii/proto';
import type { RecordsReader } from '../reading/recording-reader.ts';
import { alignOutputs, type OutputPair } from './align-outputs.ts';
import type { CompareOptions } from './compare-options.ts';
import { readInputTimes } from './input-times.ts';
import { TopicOutputs } from './topic-outputs.ts';

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
  /** The first ones, in the order of time. */
  readonly differences: readonly OutputDifference[];
}

const MAX_DIFFERENCES = 20;
const PROGRESS_OUTPUTS = 500;
const NS_PER_MS = 1_000_000;

/**
 * Compares what was recorded on output topics with what a run of the recorded inputs wrote.
 *
 * @throws the reason of `options.signal` when it is aborted
 */
export async function compareOutputs(
  recorded: RecordsReader,
  rerun: RecordsReader,
  options: CompareOptions,
): Promise<TopicComparison[]> {
  const { topics, mapTopic, inputs, mapInput, span, signal, onProgress } = options;
  const inputTimes = await readInputTimes(recorded, rerun, { inputs, mapInput, span, signal });
  const tolerances = {
    toleranceNs: BigInt(Math.round(options.toleranceMs * NS_PER_MS)),
    relativeTolerance: options.relativeTolerance,
  };
  const untilNs = span?.untilNs ?? recorded.summary.endNs;
  const comparisons: TopicComparison[] = [];
  let count = 0;
  for (const topic of topics) {
    const comparison = new RunningComparison(topic, options.maxDifferences ?? MAX_DIFFERENCES);
    const pairs = alignOutputs(
      new TopicOutputs(recorded.records({ topics: [topic], ...span })),
      new TopicOutputs(rerun.records({ topics: [mapTopic(topic)] }), (timeNs) =>
        inputTimes.toRecorded(timeNs),
      ),
      tolerances,
    );
    for await (const pair of pairs) {
      signal?.throwIfAborted();
      // The run goes on for a moment after its last input.
      if (pair.recorded === undefined && pair.rerun!.timeNs > untilNs) continue;
      comparison.add(pair);
      if (++count % PROGRESS_OUTPUTS === 0) onProgress?.(count);
    }
    comparisons.push(comparison.result);
  }
  return comparisons;
}

class RunningComparison {
  readonly #topic: string;
  readonly #maxDifferences: number;
  readonly #counts = { same: 0, different: 0, missing: 0, additional: 0 };
  readonly #differences: OutputDifference[] = [];

  constructor(topic: string, maxDifferences: number) {
    this.#topic = topic;
    this.#maxDifferences = maxDifferences;
  }

  get result(): TopicComparison {
    return { topic: this.#topic, ...this.#counts, differences: this.#differences };
  }

  add({ recorded, rerun, path }: OutputPair): void {
    const kind = kindOf({ recorded, rerun, path });
    this.#counts[kind] += 1;
    if (kind === 'same' || this.#differences.length >= this.#maxDifferences) return;
    this.#differences.push({
      ...{ kind, path: path ?? '' },
      timeNs: (recorded ?? rerun)!.timeNs,
      recorded: recorded?.record,
      rerun: rerun?.record,
    });
  }
}

function kindOf({ recorded, rerun, path }: OutputPair): OutputDifference['kind'] | 'same' {
  if (rerun === undefined) return 'missing';
  if (recorded === undefined) return 'additional';
  return path === undefined ? 'same' : 'different';
}
