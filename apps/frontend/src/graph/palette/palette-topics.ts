import { isExtensionTopic, isMasterTopic } from '@ubii/proto';
import type { TopicRate } from '../../connection/topic-rates.ts';
import type { FindPublisher } from '../../topics/tree/publisher.ts';
import { rootLabel } from '../../topics/tree/topic-path.ts';

/** A topic in the palette. */
export interface PaletteTopic {
  readonly topic: string;
  /** All after its root. */
  readonly label: string;
  readonly format: string;
  readonly hz: number;
}

/** Topics of one client, or under one root. */
export interface PaletteGroup {
  readonly key: string;
  readonly name: string;
  readonly topics: readonly PaletteTopic[];
}

/** More are not read; the filter finds the rest. */
const MAX_TOPICS = 300;

/** Topics by who publishes them; what the master tells of itself is left out. */
export function paletteTopics(
  rates: readonly TopicRate[],
  words: readonly string[],
  findPublisher: FindPublisher,
): PaletteGroup[] {
  const groups = new Map<string, { name: string; topics: PaletteTopic[] }>();
  let count = 0;
  for (const { statistic, hz = 0 } of rates) {
    const { topic, dataFormat: format } = statistic;
    if (isMasterTopic(topic) || isExtensionTopic(topic) || count >= MAX_TOPICS) continue;
    const root = rootLabel(topic);
    const name = findPublisher(root)?.name ?? (root || '(no name)');
    const text = `${name} ${topic} ${format}`.toLowerCase();
    if (!words.every((word) => text.includes(word))) continue;
    count += 1;
    let group = groups.get(root);
    if (group === undefined) groups.set(root, (group = { name, topics: [] }));
    const label = topic.slice(topic.indexOf(root) + root.length).replace(/^\//, '') || topic;
    group.topics.push({ topic, label, format, hz });
  }
  return [...groups]
    .map(([key, { name, topics }]) => ({
      key,
      name,
      topics: topics.sort((a, b) => a.label.localeCompare(b.label)),
    }))
    .sort((a, b) => a.name.localeCompare(b.name));
}
