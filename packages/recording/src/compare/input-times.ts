import type { RecordsReader } from '../reading/recording-reader.ts';
import type { Abortable, ComparedSpan } from './compare-options.ts';
import { playedRecords } from './played-records.ts';

/** Moments whose offset changes by less are not kept, nanoseconds. */
const KEPT_NS = 100_000n;

/** Tells when a moment of a run was in the recording: as long after the last input as it was in the run. */
export class InputTimes {
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
export interface InputPair {
  readonly rerunNs: bigint;
  readonly recordedNs: bigint;
}

/** Finds the inputs of a recording in the run that played them: the nth record of a topic is the nth that was played. */
export async function readInputTimes(
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
