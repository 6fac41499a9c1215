import type { ServiceName } from '@ubii/proto';

/** What is known of one topic while a lesson is open. */
export interface TopicFact {
  readonly topic: string;
  readonly format: string;
  /** Records per second, from the counters of the master; 0 before they are known. */
  readonly hz: number;
  /** The numbers of the newest value received; empty before the first. */
  readonly numbers: readonly number[];
  /** The smallest and the largest of each number since the step began. */
  readonly low: readonly number[];
  readonly high: readonly number[];
}

export interface PhoneFact {
  readonly id: string;
  readonly name: string;
}

/** The session that the lesson works on. */
export interface SessionFact {
  readonly name: string;
  readonly isRunning: boolean;
  /** State in words. */
  readonly state: string;
  /** Runs per second by the name of the module, from the statistics of its node. */
  readonly runsPerSecond: ReadonlyMap<string, number>;
}

/** The try-out of the module that the lesson works on. */
export interface TryFact {
  readonly isRunning: boolean;
  /** Since the try-out started. */
  readonly runs: number;
  readonly runsPerSecond: number;
  /** The topic that feeds the first input; undefined while values of the form do. */
  readonly inputTopic: string | undefined;
  /** First numbers of the newest values of the first output, oldest first. */
  readonly series: readonly number[];
}

/** A call of a service since the step began. */
export interface CallFact {
  readonly service: ServiceName;
  readonly request: unknown;
  /** The reply as JSON; undefined when the call failed. */
  readonly reply: unknown;
  /** The error code; undefined when there was a reply. */
  readonly errorCode: string | undefined;
  readonly tookMs: number;
}

/** Everything that checks look at: what runs now, never a text that was written. */
export interface LessonFacts {
  /** Id of this page's client. */
  readonly ownId: string;
  /** Clients with the smart device, phones and frames alike. */
  readonly phones: readonly PhoneFact[];
  /** Names of all clients. */
  readonly clientNames: readonly string[];
  readonly topics: ReadonlyMap<string, TopicFact>;
  readonly session: SessionFact | undefined;
  readonly tried: TryFact | undefined;
  /** Newest first. */
  readonly calls: readonly CallFact[];
}

export const NO_FACTS: LessonFacts = {
  ownId: '',
  phones: [],
  clientNames: [],
  topics: new Map(),
  session: undefined,
  tried: undefined,
  calls: [],
};

/** The values of one topic since the step began. */
export type ValueRange = Pick<TopicFact, 'numbers' | 'low' | 'high'>;

export const NO_VALUES: ValueRange = { numbers: [], low: [], high: [] };

/** The range with one more value. */
export function withValue({ low, high }: ValueRange, numbers: readonly number[]): ValueRange {
  return {
    numbers,
    low: numbers.map((number, index) => Math.min(number, low[index] ?? number)),
    high: numbers.map((number, index) => Math.max(number, high[index] ?? number)),
  };
}
