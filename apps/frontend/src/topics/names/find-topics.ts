import type { TopicRate } from '../../connection/topic-rates.ts';
import { isInternalTopic } from './internal-topics.ts';

/** Words of a search, in lower case. */
export const searchWords = (text: string): readonly string[] =>
  text.trim().toLowerCase().split(/\s+/).filter(Boolean);

/** Returns the topics with a value whose name or data format contains every word, sorted by name; those of the master last. */
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
    .sort((a, b) => lastOf(a.topic) - lastOf(b.topic) || a.topic.localeCompare(b.topic));
}

/** Announcements of the master are rarely what the user looks for. */
const lastOf = (topic: string): number => (topic.startsWith('/info/') ? 1 : 0);
