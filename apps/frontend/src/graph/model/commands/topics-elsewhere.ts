import type { Session } from '@ubii/proto';
import { mappedTopics, writtenTopics } from '../../../sessions/words/shared-topics.ts';

/** Topics that others use: other sessions, and clients that publish. */
export interface TopicsElsewhere {
  /** Topics that no new wire may use. */
  readonly used: ReadonlySet<string>;
  /** Topics that others read from this session: renaming one would cut them off. */
  readonly needed: ReadonlySet<string>;
}

/** Returns the topics that others use at the time of a command. */
export type FindTopicsElsewhere = () => TopicsElsewhere;

const NO_TOPICS: TopicsElsewhere = { used: new Set(), needed: new Set() };
export const nothingElsewhere: FindTopicsElsewhere = () => NO_TOPICS;

/**
 * @param sessions all other sessions, running or not
 * @param published topics that others publish
 * @param read topics that devices read
 */
export function topicsElsewhere(
  sessions: readonly Pick<Session, 'ioMappings' | 'processingModules'>[],
  published: readonly string[] = [],
  read: readonly string[] = [],
): TopicsElsewhere {
  const written = new Set(sessions.flatMap((session) => [...writtenTopics(session)]));
  const mapped = sessions.flatMap(mappedTopics);
  return {
    used: new Set([...mapped, ...published, ...read]),
    needed: new Set([...mapped, ...read].filter((topic) => !written.has(topic))),
  };
}
