import type { ComponentSelection } from './component-selection.ts';
import type { Outbox } from './outbox.ts';
import type { Pattern } from './pattern.ts';
import type { Sampler } from './sampler.ts';
import type { TokenBucket } from './token-bucket.ts';
import type { TopicEntry } from './topic-entry.ts';

/** One client as somebody who subscribes: its subscriptions stand without a socket [TD-20]. */
export interface Subscriber {
  readonly clientId: string;
  /** Gets topics under /ubii/, and retained records for patterns and profiles [TD-24] [TD-26]. */
  readonly isExtension: boolean;
  readonly outbox: Outbox;
  readonly sampler: Sampler;
  /** Milliseconds that matching its patterns may take [TD-29]. */
  readonly patternBudget: TokenBucket;
  readonly topics: Set<TopicEntry>;
  readonly patterns: Set<Pattern>;
  readonly selections: Set<ComponentSelection>;
  /** Ids of its devices that watch everything [DV-3]. */
  readonly watchers: Set<string>;
}
