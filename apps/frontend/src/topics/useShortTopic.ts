import { rootLabel } from './tree/topic-path.ts';
import { useFindPublisher } from './useFindPublisher.ts';

/** Ids are long and all alike; this much of one tells clients apart. */
const ID_LENGTH = 8;

/** A topic as people can read it. */
export interface ShortTopic {
  /** The topic, with most of a client's id left out. */
  readonly text: string;
  /** What the client is called whose id the topic begins with. */
  readonly owner: string | undefined;
}

/** Shortens topics that begin with the id of a client, and says whose they are. */
export function useShortTopic(): (topic: string) => ShortTopic {
  const findPublisher = useFindPublisher();
  return (topic) => {
    const root = rootLabel(topic);
    const owner = findPublisher(root)?.name;
    if (owner === undefined || root.length <= ID_LENGTH) return { text: topic, owner: undefined };
    return { text: topic.replace(root, `${root.slice(0, ID_LENGTH)}…`), owner };
  };
}
