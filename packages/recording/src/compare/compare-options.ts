/** A part of a recording, nanoseconds since the Unix epoch, both ends inclusive. */
export interface ComparedSpan {
  readonly fromNs: bigint;
  readonly untilNs: bigint;
}

export interface Abortable {
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
  /** What was played. @default all */
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
