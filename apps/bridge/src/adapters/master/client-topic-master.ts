import type { UbiiClient } from '@ubii/client-web/node';
import { ClientState } from '@ubii/proto';
import type { OtherBridges } from '../../core/loop/other-bridges.ts';
import type { TopicMaster } from '../../core/ports/topic-master.ts';

/** The topics of the master that a client is connected to. */
export function createTopicMaster(client: UbiiClient): TopicMaster {
  return {
    get ownId() {
      return client.id;
    },
    publish(topic, format, value, timestampMs) {
      client.publish(topic, format, value as never, {
        ...(timestampMs !== undefined && { timestampMs }),
      });
    },
    endTopic: (topic) => client.endTopic(topic),
    subscribe: (pattern, listener) => client.subscribeEncoded(pattern, listener),
  };
}

/**
 * Follows which clients are bridges. Resolves when all that are there now are known: then the announcement of the client itself has
 * come, which the master sends with theirs. [BR-22]
 */
export async function watchBridges(client: UbiiClient, bridges: OtherBridges): Promise<void> {
  const announcements = client.subscribe({ glob: '/ubii/client/*' }, { format: 'client' });
  await new Promise<void>((resolve, reject) => {
    announcements.onRecord(({ value: { id, tags, state } }) => {
      bridges.handleClient({ id, tags, isGone: state === ClientState.UNAVAILABLE });
      if (id === client.id) resolve();
    });
    announcements.ready.catch(reject);
  });
}
