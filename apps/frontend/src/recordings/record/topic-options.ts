import { isExtensionTopic, isMasterTopic } from '@ubii/proto';
import { isInternalTopic } from '../../topics/names/internal-topics.ts';
import { topicLabels, type NameOf } from '../timeline/topic-label.ts';

/** Topics that can be chosen to be recorded, those of a client together. Topics of the master are never recorded. [RC-12] */
export function topicOptionsOf(
  statistics: readonly { readonly topic: string; readonly dataFormat: string }[],
  nameOf: NameOf,
): { readonly value: string; readonly text: string; readonly detail: string }[] {
  const formats = new Map(statistics.map(({ topic, dataFormat }) => [topic, dataFormat]));
  const topics = [...formats.keys()].filter(
    (topic) => !isMasterTopic(topic) && !isExtensionTopic(topic) && !isInternalTopic(topic),
  );
  topics.sort((a, b) => withoutSlash(a).localeCompare(withoutSlash(b)));
  const labels = topicLabels(topics, nameOf);
  return topics.map((value) => ({
    value,
    text: labels.get(value) ?? value,
    detail: formats.get(value) ?? '',
  }));
}

/** Some topics of existing clients have no slash in front of the id. */
const withoutSlash = (topic: string): string => topic.replace(/^\//, '');
