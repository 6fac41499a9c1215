import { rootLabel } from './topic-path.ts';
import { useFindPublisher } from './useFindPublisher.ts';

/** Topic in display form. */
export interface ShortTopic {
  /** The topic, without the id of a client at its beginning: `/touch_events`. */
  readonly text: string;
  /** Display name of the client whose id the topic begins with. */
  readonly owner: string | undefined;
}

/** Replaces client ids in topics by the names of the clients. */
export function useShortTopic(): (topic: string) => ShortTopic {
  const findPublisher = useFindPublisher();
  return (topic) => {
    const root = rootLabel(topic);
    const owner = findPublisher(root)?.name;
    const text = topic.slice(topic.indexOf(root) + root.length);
    if (owner === undefined || text === '') return { text: topic, owner: undefined };
    return { text, owner };
  };
}
