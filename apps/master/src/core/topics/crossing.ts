import { isMasterTopic } from '@ubii/proto';

/** Statistics and events of sessions, which the master that runs them publishes. */
const SESSION_PREFIX = '/ubii/session/';

/**
 * Whether records of this topic go to other masters, if subscribers there want them. What every master says itself,
 * such as who came, each says to its own clients. [CU-16]
 */
export function crosses(topic: string): boolean {
  return topic.startsWith(SESSION_PREFIX) || !isMasterTopic(topic);
}
