import type { ServiceName } from '@ubii/proto';

/** State of a topic while a lesson is open. */
export interface TopicFact {
  readonly topic: string;
  readonly format: string;
  /** Records per second, from the master's statistics; 0 before they are known. */
  readonly hz: number;
  /** Numbers of the newest value; empty before the first. */
  readonly numbers: readonly number[];
  /** Minimum and maximum of each number since the step started. */
  readonly low: readonly number[];
  readonly high: readonly number[];
}

export interface PhoneFact {
  readonly id: string;
  readonly name: string;
}

/** Session of the lesson. */
export interface SessionFact {
  readonly name: string;
  readonly isRunning: boolean;
  /** Status in words. */
  readonly state: string;
  /** Runs per second by module name, from the statistics of its node. */
  readonly runsPerSecond: ReadonlyMap<string, number>;
}

/** Try-out of the lesson's module. */
export interface TryFact {
  readonly isRunning: boolean;
  /** Number of runs since the try-out started. */
  readonly runs: number;
  readonly runsPerSecond: number;
  /** Topic of the first input; undefined while the form provides values. */
  readonly inputTopic: string | undefined;
  /** First numbers of the newest values of the first output, oldest first. */
  readonly series: readonly number[];
}

/** A call of a service since the step started. */
export interface CallFact {
  readonly service: ServiceName;
  readonly request: unknown;
  /** The reply as JSON; undefined when the call failed. */
  readonly reply: unknown;
  /** The error code; undefined when there was a reply. */
  readonly errorCode: string | undefined;
  readonly tookMs: number;
}

/** Everything that checks examine: the running system, never the text that the user wrote. */
export interface LessonFacts {
  /** Id of this page's client. */
  readonly ownId: string;
  /** Clients with a smart device: phones and frames. */
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

/** Values of a topic since the step started. */
export type ValueRange = Pick<TopicFact, 'numbers' | 'low' | 'high'>;

export const NO_VALUES: ValueRange = { numbers: [], low: [], high: [] };

/** Extends the range by a value. */
export function withValue({ low, high }: ValueRange, numbers: readonly number[]): ValueRange {
  return {
    numbers,
    low: numbers.map((number, index) => Math.min(number, low[index] ?? number)),
    high: numbers.map((number, index) => Math.max(number, high[index] ?? number)),
  };
}
