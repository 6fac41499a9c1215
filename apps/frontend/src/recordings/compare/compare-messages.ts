import type { OutputDifference, TopicComparison } from '@ubii/recording/compare';
import type { MasterFile } from '../files/readable-file.ts';
import type { Span } from '../timeline/span.ts';

/** Two recordings to compare. */
export interface CompareRequest {
  /** With the recorded outputs. */
  readonly recordedFile: MasterFile;
  /** With the inputs and outputs of the run. */
  readonly rerunFile: MasterFile;
  /** Prefixes that topics have in the run. */
  readonly inputPrefix: string;
  readonly outputPrefix: string;
  /** Output topics of the session; others that the run wrote are compared as well. */
  readonly outputs: readonly string[];
  /** What was played, milliseconds since the beginning; undefined for all. */
  readonly span: Span | undefined;
}

/** Outputs of one topic. */
export type ComparedTopic = Omit<TopicComparison, 'differences' | 'atEdges'>;

/** Where today's modules wrote something else. */
export interface ListedDifference {
  readonly kind: OutputDifference['kind'];
  readonly topic: string;
  /** Milliseconds since the beginning of the recording. */
  readonly timeMs: number;
  /** First member that differs; empty for the value itself. */
  readonly path: string;
  /** Values in one line; undefined where there is none. */
  readonly recorded: string | undefined;
  readonly today: string | undefined;
}

/** Result of a comparison. */
export interface SessionComparison {
  /** Those with most other values first. */
  readonly topics: readonly ComparedTopic[];
  /** The first ones of each topic and kind, by time. */
  readonly differences: readonly ListedDifference[];
}

/** What the page calls of the worker that compares. */
export interface CompareWorker {
  compare(request: CompareRequest): Promise<SessionComparison>;
}

/** What the worker calls of the page. */
export interface ComparePage {
  /** @param outputs that are compared so far */
  showProgress(outputs: number): void;
}
