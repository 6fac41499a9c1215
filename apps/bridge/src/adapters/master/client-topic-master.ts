import type { UbiiClient } from '@ubii/client-web/node';
import type { Clock } from '@ubii/timing';
import type { TopicMaster } from '../../core/ports/topic-master.ts';

/** The list is asked for again after this time, milliseconds: the page asks for a preview after each pause in typing. */
const KEPT_MS = 3_000;

/** Returns a function that lists the topics of the master, as of the last request. */
export function cachedTopics(client: UbiiClient, clock: Clock): () => Promise<readonly string[]> {
  let list: readonly string[] = [];
  let askedMs = -Infinity;
  return async () => {
    const nowMs = clock.monotonicMs();
    if (nowMs - askedMs < KEPT_MS) return list;
    ({ elements: list } = await client.call('topicList'));
    askedMs = nowMs;
    return list;
  };
}

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
