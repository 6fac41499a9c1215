import { preflightTopic } from '@ubii/proto';
import { isPageStateTopic } from '../../connection/page-state.ts';
import { isPresenceTopic } from './presence-topic.ts';

/** Every page of the frontend subscribes to it, mostly without any publisher. */
const IDENTIFY_TOPIC = /^\/[^/]+\/identify$/;

/** What a page found when it joined, for the host's page. [AC-30] */
const isPreflightTopic = (topic: string): boolean =>
  topic === preflightTopic(topic.split('/')[1] ?? '');

/**
 * Topics that the frontend uses internally: ordinary topic data, but irrelevant for users who look for their own
 * topics. Lists and trees omit them; they can be opened by name. [EX-49] [EX-56]
 */
export const isInternalTopic = (topic: string): boolean =>
  isPresenceTopic(topic) ||
  isPageStateTopic(topic) ||
  isPreflightTopic(topic) ||
  IDENTIFY_TOPIC.test(topic);
