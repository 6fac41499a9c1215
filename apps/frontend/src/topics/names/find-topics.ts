import type { TopicRate } from '../../connection/topic-rates.ts';
import { isInternalTopic } from './internal-topics.ts';

/** The words of a search, in small letters. */
export const searchWords = (text: string): readonly string[] =>
  text.trim().toLowerCase().split(/\s+/).filter(Boolean);

/** Topics with a value whose name or data format has every word, by name. */
export function findTopics(
  rates: ReadonlyMap<string, TopicRate> | undefined,
  words: readonly string[],
): readonly { readonly topic: string; readonly format: string }[] {
  return [...(rates?.values() ?? [])]
    .map(({ statistic: { topic, dataFormat } }) => ({ topic, format: dataFormat }))
    .filter(({ topic, format }) => {
      const text = `${topic} ${format}`.toLowerCase();
      return format !== '' && !isInternalTopic(topic) && words.every((word) => text.includes(word));
    })
    .sort((a, b) => a.topic.localeCompare(b.topic));
}
