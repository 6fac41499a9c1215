import { READERS } from '../access/roles.ts';
import { readTopicStatistics } from '../topics/topic-statistics.ts';
import { definer } from './define-service.ts';
import { topicSubscribers } from './topic-subscribers.ts';
import { topicSubscription } from './topic-subscription.ts';

const define = definer<'topics' | 'clock' | 'masters'>();

/** Services on topics and subscriptions. */
export const TOPIC_SERVICES = [
  topicSubscription,
  topicSubscribers,
  // [EX-11]
  define('topicStatistics', {
    roles: READERS,
    handle({ topics, clock, masters }, { cursor }, call) {
      return masters === undefined || call.isOfMaster
        ? readTopicStatistics(topics, cursor, clock.nowMs())
        : masters.topicStatistics(cursor, call.facts); // [CU-29]
    },
  }),
];
