import { isLongerThan } from '@ubii/words';
import { isMasterTopic } from '@ubii/proto';

// eslint-disable-next-line no-control-regex -- control characters are what it looks for
const CONTROL_CHARACTER = /[\u0000-\u001f\u007f-\u009f]/;

/** Reasons why a text is not a valid topic. */
type TopicFault = 'is empty' | 'is too long' | 'contains a control character';

/** Why this text cannot be a topic; undefined when it can [TD-13]. */
export function topicFault(topic: string, maxBytes: number): TopicFault | undefined {
  if (topic === '') return 'is empty';
  if (isLongerThan(topic, maxBytes)) return 'is too long';
  return CONTROL_CHARACTER.test(topic) ? 'contains a control character' : undefined;
}

/** Statistics and events of sessions, which the master that runs them publishes. */
const SESSION_PREFIX = '/ubii/session/';

/**
 * Records of this topic go to other masters with subscribers. What every master publishes itself,
 * such as announcements, each sends to its own clients. [CU-16]
 */
export function isSharedTopic(topic: string): boolean {
  return topic.startsWith(SESSION_PREFIX) || !isMasterTopic(topic);
}
