import type { Client } from '../clients/client.ts';
import type { Core } from '../core.ts';
import type { TopicEntry } from '../topics/topic-entry.ts';
import type { ServiceCall } from './handler.ts';

/** Sends the client the retained records of these topics once the reply has left [TD-24]. */
export function replayAfterReply(
  { topics }: Core,
  call: ServiceCall,
  client: Client,
  entries: readonly TopicEntry[],
): void {
  if (entries.length === 0) return;
  const sinceSequence = topics.sequence;
  call.afterReply(() => {
    if (client.status === 'removed') return;
    for (const entry of entries) client.subscriber.outbox.replay(entry, sinceSequence);
  });
}
