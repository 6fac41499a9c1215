import type { Outbox } from './outbox.ts';
import type { Sampler } from './sampler.ts';
import type { Subscriber } from './topic-entry.ts';

/** A client as a subscriber. Its subscriptions stay while it has no socket [TD-20]. */
export interface ClientSubscriber extends Subscriber {
  readonly outbox: Outbox;
  readonly sampler: Sampler;
}
