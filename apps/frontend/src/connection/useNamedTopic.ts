import { replaceClientTopics, topicParts } from './topic-parts.ts';
import { useConnection } from './useConnection.ts';

/** Formats a topic for display: one that starts with a client id as the rest and the client's name. */
export type NameTopic = (topic: string) => string;

/** Formats client topics within a text for display. */
export function useNamedTopics(): (text: string) => string {
  const nameTopic = useNamedTopic();
  return (text) => replaceClientTopics(text, nameTopic);
}

export function useNamedTopic(): NameTopic {
  const { client, clients } = useConnection();
  return (topic) => {
    void clients.list.value;
    const { name, place, owner } = topicParts(topic, client.id, (id) => clients.find(id)?.name);
    if (owner === undefined) return topic;
    return `${place === '' ? name : `${place}/${name}`} · ${owner}`;
  };
}
