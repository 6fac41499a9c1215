import { isPageStateTopic } from '../../connection/page-state.ts';
import { isPresenceTopic } from './presence-topic.ts';

/** Every page of ours listens there; nothing has ever been published on most. */
const IDENTIFY_TOPIC = /^\/[^/]+\/identify$/;

/**
 * Topics that the frontend uses internally: ordinary topic data, but of no interest to users who look
 * for their own topics. Lists and trees of topics leave them out; by its name, each is still found and read.
 * [EX-49] [EX-56]
 */
export const isInternalTopic = (topic: string): boolean =>
  isPresenceTopic(topic) || isPageStateTopic(topic) || IDENTIFY_TOPIC.test(topic);
