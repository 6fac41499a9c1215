import { ComponentIOType } from '@ubii/proto';
import { useConnection } from '../../connection/useConnection.ts';
import { mappedTopics } from '../../sessions/words/shared-topics.ts';
import { topicsElsewhere, type FindTopicsElsewhere } from '../model/commands/topics-elsewhere.ts';

/** Finds the topics that others than this session use: other sessions, clients that publish, and devices. */
export function useTopicsElsewhere(sessionId: string): FindTopicsElsewhere {
  const { clients, masterId, sessions, topics } = useConnection();
  return () => {
    const all = sessions.list.value ?? [];
    const others = all.filter(({ id }) => id !== sessionId);
    // Outputs of this session may come from a client that runs its modules.
    const own = new Set(all.filter(({ id }) => id === sessionId).flatMap(mappedTopics));
    const published = [...(topics.rates.value?.values() ?? [])]
      .map(({ statistic }) => statistic)
      .filter(({ publishedMs, publisherId }) => publishedMs > 0 && publisherId !== '')
      .filter(({ topic, publisherId }) => publisherId !== masterId.value && !own.has(topic));
    const read = (clients.list.value ?? [])
      .flatMap(({ devices }) => devices.flatMap(({ components }) => components))
      .filter(({ ioType }) => ioType === ComponentIOType.SUBSCRIBER);
    return topicsElsewhere(
      others,
      published.map(({ topic }) => topic),
      read.map(({ topic }) => topic),
    );
  };
}
