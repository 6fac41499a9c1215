import { globToRegExpSource, ServiceError, type RecordingSelection } from '@ubii/proto';
import { TokenBucket, type Clock } from '@ubii/timing';
import type { Limits } from '../limits/index.ts';
import type { Accounts } from '../shares/accounts.ts';
import { localSubscriber } from '../topics/local-subscriber.ts';
import type { SubscriptionTable } from '../topics/subscription-table.ts';
import type { Receiver } from '../topics/topic-entry.ts';

/** Dependencies of the interest of recordings. */
export interface InterestContext {
  readonly subscriptions: SubscriptionTable;
  readonly accounts: Accounts;
  readonly limits: Limits;
  readonly clock: Clock;
}

/** Subscribes to what recordings select, so that the other masters of a cluster send it. [CU-17] */
export type RecordingInterest = (selection: RecordingSelection) => () => void;

/** Stands for the device of a subscriber that watches everything. */
const EVERY_RECORD = 'recording';
/** Globs take no more time than the recorder takes for them: they are not counted twice. */
const UNBOUNDED_MS = 1e12;

/** The recorder takes records before they are delivered [RC-50]: nothing is left to do. */
const TAKEN: Receiver = {
  deliver: () => undefined,
  replay: () => undefined,
  handleGone: () => undefined,
  withdraw: () => undefined,
  cancelReplay: () => undefined,
};

/** Interest for a master of a cluster. */
export function recordingInterest(context: InterestContext): RecordingInterest {
  const { subscriptions, accounts, limits, clock } = context;
  return (selection) => {
    const subscriber = {
      ...localSubscriber('', TAKEN, accounts.master, limits, clock),
      patternBudget: new TokenBucket(UNBOUNDED_MS, clock.monotonicMs()),
    };
    try {
      if (!isNamed(selection)) subscriptions.watch(subscriber, EVERY_RECORD);
      for (const topic of selection.topics) subscriptions.subscribeTopic(subscriber, topic, 0);
      for (const glob of selection.patterns) {
        subscriptions.subscribePattern(subscriber, globToRegExpSource(glob), 0);
      }
    } catch (cause) {
      if (!(cause instanceof ServiceError)) throw cause;
      // A limit was met: more records than necessary are sent, and none is missing.
      subscriptions.unsubscribeAll(subscriber);
      subscriptions.watch(subscriber, EVERY_RECORD);
    }
    return () => subscriptions.unsubscribeAll(subscriber);
  };
}

/** Whether topics and globs say all that is selected. Topics of clients, devices and sessions are known later. */
function isNamed({ topics, patterns, clients, devices, sessions }: RecordingSelection): boolean {
  const isFurther = [clients, devices, sessions].some((list) => list.length > 0);
  return !isFurther && topics.length + patterns.length > 0;
}
