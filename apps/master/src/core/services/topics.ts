import { READERS } from '../access/roles.ts';
import { readTopicStatistics } from '../topics/topic-statistics.ts';
import { definer } from './define-service.ts';
import { topicSubscribers } from './topic-subscribers.ts';
import { topicSubscription } from './topic-subscription.ts';

const define = definer<'topics' | 'clock'>();

/** Services on topics and subscriptions. */
export const TOPIC_SERVICES = [
  topicSubscription,
  topicSubscribers,
  // [EX-11]
  define('topicStatistics', {
    roles: READERS,
    handle: ({ topics, clock }, { cursor }) => readTopicStatistics(topics, cursor, clock.nowMs()),
  }),
];
