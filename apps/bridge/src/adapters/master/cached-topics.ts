import type { UbiiClient } from '@ubii/client-web/node';
import type { Clock } from '@ubii/timing';

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
