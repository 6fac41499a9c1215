import { useConnection } from './useConnection.ts';

/** Names a topic for people: of one that begins with the id of a client, the rest and the client's name. */
export type NameTopic = (topic: string) => string;

export function useNamedTopic(): NameTopic {
  const { clients } = useConnection();
  return (topic) => {
    void clients.list.value;
    const [, root = '', ...rest] = topic.split('/');
    const name = clients.find(root)?.name;
    return name && rest.length > 0 ? `${rest.join('/')} · ${name}` : topic;
  };
}
