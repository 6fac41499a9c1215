import type { RecordsReader } from '../reading/recording-reader.ts';
import type { RecordedRecord } from '../records/recorded-record.ts';
import type { OutputPair } from './align-outputs.ts';
import { compareTopic, type TopicComparison } from './compare-topic.ts';
import { decodedOutput, type Output } from './output-queue.ts';

/** A part of a recording, nanoseconds since the Unix epoch, both ends inclusive. */
export interface ComparedSpan {
  readonly fromNs: bigint;
  readonly untilNs: bigint;
}

interface Abortable {
  readonly signal?: { throwIfAborted(): void } | undefined;
}

/** What is compared, and how exactly. */
export interface CompareOptions extends Abortable {
  /** Output topics of the recording. */
  readonly topics: readonly string[];
  /** Topic of the run on which an output topic was written. */
  readonly mapTopic: (topic: string) => string;
  /** Input topics of the recording that were played: they tell which moment of the recording a moment of the run is. */
  readonly inputs: readonly string[];
  /** Topic of the run on which an input topic was played. */
  readonly mapInput: (topic: string) => string;
  /** The part that was played. @default all */
  readonly span?: ComparedSpan | undefined;
  /** Outputs further apart than this do not belong together, milliseconds. */
  readonly toleranceMs: number;
  /** Numbers are the same when they differ by at most this share of the larger one. */
  readonly relativeTolerance: number;
  /** How many differences of each kind are listed of an output topic, with their values. @default 20 */
  readonly maxDifferences?: ((topic: string) => number) | undefined;
  /** Called now and then with the number of outputs compared so far. */
  readonly onProgress?: (outputs: number) => void;
}

/**
 * Reads what a playback of a span emits, with the time at which that is: first the value of each topic where it begins, then the
 * records after that.
 */
async function* playedRecords(
  reader: RecordsReader,
  topics: readonly string[],
  span: ComparedSpan | undefined,
): AsyncGenerator<RecordedRecord> {
  const { startNs, endNs } = reader.summary;
  const fromNs = span?.fromNs ?? startNs;
  const latest = await reader.latestAt(fromNs, topics);
  for (const record of latest.values()) yield { ...record, logTimeNs: fromNs };
  yield* reader.records({ topics, fromNs: fromNs + 1n, untilNs: span?.untilNs ?? endNs });
}

/** Moments whose offset changes by less are not kept, nanoseconds. */
const KEPT_NS = 100_000n;

/** Maps times of a run to times of the recording: as long after the last input as in the run. */
class InputTimes {
  readonly #rerunNs: bigint[] = [];
  /** Time of the run minus time of the recording. */
  readonly #offsetsNs: bigint[] = [];

  /** @param pairs times of the same input, in the order of the run */
  constructor(pairs: Iterable<InputPair>) {
    for (const { rerunNs, recordedNs } of pairs) {
      const offsetNs = rerunNs - recordedNs;
      const before = this.#offsetsNs.at(-1);
      if (before !== undefined && difference(before, offsetNs) < KEPT_NS) continue;
      this.#rerunNs.push(rerunNs);
      this.#offsetsNs.push(offsetNs);
    }
  }

  /** @returns the moment of the recording; the same moment when no input was found */
  toRecorded(rerunNs: bigint): bigint {
    let low = 0;
    let high = this.#rerunNs.length - 1;
    while (low < high) {
      const middle = Math.ceil((low + high) / 2);
      if (this.#rerunNs[middle]! <= rerunNs) low = middle;
      else high = middle - 1;
    }
    return rerunNs - (this.#offsetsNs[low] ?? 0n);
  }
}

/** When one input was recorded, and when it was played. */
interface InputPair {
  readonly rerunNs: bigint;
  readonly recordedNs: bigint;
}

/** Finds the inputs of a recording in the run that played them: the nth record of a topic is the nth that was played. */
async function readInputTimes(
  recorded: RecordsReader,
  rerun: RecordsReader,
  { inputs, mapInput, span, signal }: InputOptions & Abortable,
): Promise<InputTimes> {
  const recordedNs = new Map<string, bigint[]>(inputs.map((topic) => [mapInput(topic), []]));
  for await (const { topic, logTimeNs } of playedRecords(recorded, inputs, span)) {
    signal?.throwIfAborted();
    recordedNs.get(mapInput(topic))?.push(logTimeNs);
  }
  const played = new Map<string, number>();
  const pairs: InputPair[] = [];
  for await (const { topic, logTimeNs } of rerun.records({ topics: [...recordedNs.keys()] })) {
    signal?.throwIfAborted();
    const place = played.get(topic) ?? 0;
    played.set(topic, place + 1);
    const timeNs = recordedNs.get(topic)?.[place];
    if (timeNs !== undefined) pairs.push({ rerunNs: logTimeNs, recordedNs: timeNs });
  }
  return new InputTimes(pairs);
}

interface InputOptions {
  readonly inputs: readonly string[];
  readonly mapInput: (topic: string) => string;
  readonly span: ComparedSpan | undefined;
}

const difference = (a: bigint, b: bigint): bigint => (a > b ? a - b : b - a);

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
    // The run continues for a moment after its last input.
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
      topic,
      onPair,
      isSampled: true,
      absoluteTolerance: SMALLEST,
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
