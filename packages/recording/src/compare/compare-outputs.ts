import type { RecordsReader } from '../reading/recording-reader.ts';
import type { RecordedRecord } from '../records/recorded-record.ts';
import type { OutputPair } from './align-outputs.ts';
import type { CompareOptions } from './compare-options.ts';
import { compareTopic, type TopicComparison } from './compare-topic.ts';
import { readInputTimes } from './input-times.ts';
import { decodedOutput, type Output } from './output-queue.ts';

const PROGRESS_OUTPUTS = 500;
const NS_PER_MS = 1_000_000;
/** Numbers closer to each other than this are the same. */
const SMALLEST = 1e-12;

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
  const untilNs = span?.untilNs ?? recorded.summary.endNs;
  let count = 0;
  const onPair = (pair: OutputPair): boolean => {
    signal?.throwIfAborted();
    // The run goes on for a moment after its last input.
    if (pair.recorded === undefined && pair.rerun!.timeNs > untilNs) return false;
    if (++count % PROGRESS_OUTPUTS === 0) onProgress?.(count);
    return true;
  };
  const comparisons: TopicComparison[] = [];
  for (const topic of topics) {
    const before = outputsOf(recorded.records({ topics: [topic], ...span }), (timeNs) => timeNs);
    const after = outputsOf(rerun.records({ topics: [mapTopic(topic)] }), (timeNs) =>
      inputTimes.toRecorded(timeNs),
    );
    const comparison = await compareTopic(before, after, {
      ...{ topic, onPair, isSampled: true, absoluteTolerance: SMALLEST },
      toleranceNs: BigInt(Math.round(options.toleranceMs * NS_PER_MS)),
      relativeTolerance: options.relativeTolerance,
      maxDifferences: options.maxDifferences?.(topic),
    });
    comparisons.push(comparison);
  }
  return comparisons;
}

async function* outputsOf(
  records: AsyncIterable<RecordedRecord>,
  toRecorded: (timeNs: bigint) => bigint,
): AsyncGenerator<Output> {
  for await (const { logTimeNs, record } of records)
    yield { timeNs: toRecorded(logTimeNs), record: decodedOutput(record) };
}
