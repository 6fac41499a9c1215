import type { Client } from '../clients/client.ts';
import type { Core } from '../areas/core.ts';
import type { TopicEntry } from '../topics/topic-entry.ts';
import type { ServiceCall } from './service-call.ts';

/** Sender of retained records. */
export type AfterReplyContext = Pick<Core, 'topics' | 'subscriptions' | 'clock' | 'limits'>;

/**
 * Sends the client the retained records of these topics once the reply has left [TD-24]. Existing
 * clients know the callback only some turns after they read the reply: they are given the time.
 */
export function replayAfterReply(
  { topics, subscriptions, clock, limits }: AfterReplyContext,
  call: ServiceCall,
  client: Client,
  entries: readonly TopicEntry[],
): void {
  if (entries.length === 0) return;
  const sinceSequence = topics.sequence;
  const replay = (): void => {
    const { subscriber } = client;
    for (const entry of entries) {
      // It may have gone, or changed its mind, in the meantime.
      if (subscriptions.isSubscribed(subscriber, entry)) {
        subscriber.outbox.replay(entry, sinceSequence);
      }
    }
  };
  call.afterReply(() => {
    if (client.isExtension) replay();
    else clock.after(limits.replayDelayMs, replay);
  });
}
