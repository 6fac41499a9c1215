import { readTopicStatistics } from '../topics/topic-statistics.ts';
import type { ServiceHandler } from './handler.ts';

/** `/services/ubii/topic_statistics` [EX-11] */
export const topicStatistics: ServiceHandler = ({ topics, subscriptions, clock }, request) => {
  const { cursor } = request.topicStatisticsRequest!;
  return { topicStatistics: readTopicStatistics(topics, subscriptions, cursor, clock.nowMs()) };
};

/**
 * `/services/topic_list` [SV-11]
 * @param serviceTopics The topics of the services that are answered.
 */
export function listTopics(serviceTopics: readonly string[]): ServiceHandler {
  return ({ topics }) => {
    const elements = [...serviceTopics];
    for (const { topic, record, isExtension } of topics.values()) {
      if (record !== undefined && !isExtension) elements.push(topic);
    }
    return { stringList: { elements } };
  };
}
