import { isMasterTopic } from '@ubii/proto';

/** Statistics and events of sessions, which the master that runs them publishes. */
const SESSION_PREFIX = '/ubii/session/';

/**
 * Records of this topic go to other masters with subscribers. What every master publishes itself,
 * such as announcements, each sends to its own clients. [CU-16]
 */
export function isSharedTopic(topic: string): boolean {
  return topic.startsWith(SESSION_PREFIX) || !isMasterTopic(topic);
}
