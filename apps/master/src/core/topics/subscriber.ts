import type { ReadRights } from './rights.ts';
import type { Account } from '../shares/account.ts';
import type { ComponentSelection } from './component-selection.ts';
import type { Outbox } from './outbox.ts';
import type { Pattern } from './pattern.ts';
import type { Receiver } from './receiver.ts';
import type { Sampler } from './sampler.ts';
import type { TokenBucket } from '../counters/token-bucket.ts';
import type { TopicEntry } from './topic-entry.ts';

/** A subscriber: a client, or a module on the master. */
export interface Subscriber {
  readonly clientId: string;
  /** Gets topics under /ubii/, and retained records for patterns and profiles [TD-24] [TD-26]. */
  readonly isExtension: boolean;
  readonly outbox: Receiver;
  /** Pays for its subscriptions [AC-80]. */
  readonly account: Account;
  /** Undefined: it may receive everything [AC-25]. */
  readRights: ReadRights | undefined;
  /** Undefined: gets every record. */
  readonly sampler: Sampler | undefined;
  /** Milliseconds that matching its patterns may take [TD-29]. */
  readonly patternBudget: TokenBucket;
  readonly topics: Set<TopicEntry>;
  readonly patterns: Set<Pattern>;
  readonly selections: Set<ComponentSelection>;
  /** Ids of its devices that watch everything [DV-3]. */
  readonly watchers: Set<string>;
}

/** A client as a subscriber. Its subscriptions stay while it has no socket [TD-20]. */
export interface ClientSubscriber extends Subscriber {
  readonly outbox: Outbox;
  readonly sampler: Sampler;
}
