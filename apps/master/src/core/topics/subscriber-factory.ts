import { TokenBucket, type Clock, type EndOfTurn } from '@ubii/timing';
import type { Limits } from '../limits/index.ts';
import type { Account } from '../shares/account.ts';
import type { Counters } from '../counters/counters.ts';
import { Outbox, type OutboxContext } from './outbox.ts';
import { Sampler, type SamplerContext } from './sampler.ts';
import type { ClientSubscriber } from './subscriber.ts';
import type { TopicTable } from './topic-table.ts';
import type { TurnBatches } from './turn-batches.ts';

/** Dependencies common to subscribers. */
export interface SubscriberContext {
  readonly clock: Clock;
  readonly limits: Limits;
  readonly counters: Counters;
  readonly endOfTurn: EndOfTurn;
  readonly batches: TurnBatches;
  readonly topics: TopicTable;
}

/** Makes the subscriber of a new client, or of another master. */
export type SubscriberFactory = (
  clientId: string,
  isExtension: boolean,
  account: Account,
  isPeer?: boolean,
) => ClientSubscriber;

/** More than a client can use. */
const UNBOUNDED = 1e12;

/** All subscribers share the end of the turn. */
export function subscriberFactory(context: SubscriberContext): SubscriberFactory {
  const { clock, limits, counters, endOfTurn, batches, topics } = context;
  const outboxContext: OutboxContext = {
    clock,
    limits,
    endOfTurn,
    batches,
    onSent(records, bytes) {
      counters.recordsOut += records;
      counters.bytesOut += bytes;
    },
    onDropped(entry) {
      counters.dropped++;
      topics.countDropped(entry);
    },
  };
  const samplerContext: SamplerContext = {
    clock,
    refreshTargets: (entry) => void topics.targetsOf(entry),
  };
  const { patternMatchMs, patternMatchMsPerSecond } = limits;
  return (clientId, isExtension, account, isPeer = false) => {
    const outbox = new Outbox(outboxContext, account);
    return {
      clientId,
      isPeer,
      isExtension,
      outbox,
      account,
      readRights: undefined,
      sampler: new Sampler(outbox, samplerContext, isPeer),
      // What the subscribers of another master may spend, that master watches.
      patternBudget: isPeer
        ? new TokenBucket(UNBOUNDED, clock.monotonicMs())
        : new TokenBucket(patternMatchMsPerSecond, clock.monotonicMs(), patternMatchMs),
      topics: new Set(),
      patterns: new Set(),
      selections: new Set(),
      watchers: new Set(),
    };
  };
}
