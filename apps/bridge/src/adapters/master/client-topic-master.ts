import type { UbiiClient } from '@ubii/client-web/node';
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
