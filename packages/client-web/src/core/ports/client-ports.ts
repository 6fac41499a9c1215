import type { PatternSource } from '@ubii/patterns';
import type { Clock } from '@ubii/timing';
import type { ErrorHandler } from './error-handler.ts';
import type { IdSource } from './id-source.ts';
import type { RandomSource } from './random.ts';
import type { ServiceTransport } from './service-transport.ts';
import type { TopicDataTransport } from './topic-data-transport.ts';

/** Ports of a client. */
export interface ClientPorts {
  readonly clock: Clock;
  readonly random: RandomSource;
  /** Matches the regular expressions of subscriptions. */
  readonly patterns: PatternSource;
  readonly uuid: IdSource;
  readonly services: ServiceTransport;
  readonly topicData: TopicDataTransport;
  /** Takes errors of the program's own code when the options have no `onError`. Does not throw. */
  readonly reportError: ErrorHandler;
}
