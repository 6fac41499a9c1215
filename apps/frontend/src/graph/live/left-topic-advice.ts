import type { FindPublisher } from '../../topics/names/publisher.ts';
import { rootLabel } from '../../topics/names/topic-path.ts';
import type { TopicAdvice } from '../model/live/graph-problem.ts';

/** A topic of another client. */
export interface OtherTopic {
  readonly topic: string;
  readonly format: string;
}

/** Access to alternatives for a topic. */
export interface OtherTopics {
  readonly findPublisher: FindPublisher;
  /** Whether the client is registered. */
  readonly isPresent: (clientId: string) => boolean;
  /** Topics that clients published on, best first. */
  readonly topics: () => readonly OtherTopic[];
  /** Whether all readers of the topic accept this format. */
  readonly fits: (format: string) => boolean;
  /** Replaces the topic by another one. */
  readonly use: (topic: string) => void;
}

/** Returns advice about a topic whose client is gone, with a replacement; undefined for other topics. */
export function leftTopicAdvice(topic: string, around: OtherTopics): TopicAdvice | undefined {
  const root = rootLabel(topic);
  const owner = around.findPublisher(root);
  if (owner?.isAway !== true) return undefined;
  const rest = topicWithoutRoot(topic);
  const state = around.isPresent(root) ? 'is not connected' : 'has left';
  const fact = `Topic "${rest}" has no value: its client ${owner.name} ${state}.`;
  const other = sameTopic(topic, rest, around);
  if (other === undefined) return { message: `${fact} Connect a topic of another client.` };
  const name = rest.slice(rest.lastIndexOf('/') + 1);
  return {
    message: `${fact} ${other.client} publishes the same topic.`,
    text: `Use ${name} of ${other.client}`,
    run: () => around.use(other.topic),
  };
}

/** Returns the topic of the same device and component of a client that is registered. */
function sameTopic(
  topic: string,
  rest: string,
  { findPublisher, topics, fits }: OtherTopics,
): { readonly topic: string; readonly client: string } | undefined {
  for (const one of topics()) {
    if (one.topic === topic) continue;
    if (topicWithoutRoot(one.topic) !== rest || !fits(one.format)) continue;
    const publisher = findPublisher(rootLabel(one.topic));
    if (publisher?.isAway === false) return { topic: one.topic, client: publisher.name };
  }
  return undefined;
}

/** Returns the device and component part of a client's topic. */
function topicWithoutRoot(topic: string): string {
  return topic.slice(topic.indexOf('/', 1) + 1);
}
