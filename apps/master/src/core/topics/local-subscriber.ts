import { TokenBucket, type Clock } from '@ubii/timing';
import type { Limits } from '../limits/index.ts';
import type { Account } from '../shares/account.ts';
import type { Receiver, Subscriber } from './topic-entry.ts';

/** A part of this master as a subscriber: it gets every record at once, without a queue. */
export function localSubscriber(
  clientId: string,
  outbox: Receiver,
  account: Account,
  limits: Limits,
  clock: Clock,
): Subscriber {
  const { patternMatchMs, patternMatchMsPerSecond } = limits;
  return {
    clientId,
    isPeer: false,
    isExtension: true,
    outbox,
    account,
    readRights: undefined,
    sampler: undefined,
    patternBudget: new TokenBucket(patternMatchMsPerSecond, clock.monotonicMs(), patternMatchMs),
    topics: new Set(),
    patterns: new Set(),
    selections: new Set(),
    watchers: new Set(),
  };
}
