import type { PatternSource } from '@ubii/patterns';
import type { Clock } from '@ubii/timing';
import type { ErrorHandler } from './error-handler.ts';
import type { IdSource } from './id-source.ts';
import type { MasterAt, WaysTo } from './master-ways.ts';
import type { RandomSource } from './random.ts';

/** Ports of a client. */
export interface ClientPorts {
  readonly clock: Clock;
  readonly random: RandomSource;
  /** Matches the regular expressions of subscriptions. */
  readonly patterns: PatternSource;
  readonly uuid: IdSource;
  /** The master that the program named. */
  readonly master: MasterAt;
  /** The client stays at its master without it. [CU-80] */
  readonly waysTo?: WaysTo;
  /** Takes errors of the program's own code when the options have no `onError`. Does not throw. */
  readonly reportError: ErrorHandler;
}
