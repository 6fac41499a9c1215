import type { Session } from '@ubii/proto';
import { plural } from '@ubii/words';
import { isAlive } from '../state/session-state.ts';

/** A session, as others name it. */
export interface SessionRef {
  readonly id: string;
  readonly name: string;
}

/** A topic that another session writes as well. */
export interface SharedTopic {
  readonly topic: string;
  readonly others: readonly SessionRef[];
}

/** The topics that the modules of a session write. */
export function writtenTopics({
  ioMappings,
  processingModules,
}: Pick<Session, 'ioMappings' | 'processingModules'>): Set<string> {
  const ids = new Set(processingModules.map(({ id }) => id));
  const topics = new Set<string>();
  for (const { processingModuleId, outputMappings } of ioMappings) {
    if (!ids.has(processingModuleId)) continue;
    for (const { topic } of outputMappings) if (topic) topics.add(topic);
  }
  return topics;
}

/** The topics that the modules of a session read or write, each once. */
export function mappedTopics(session: Pick<Session, 'ioMappings' | 'processingModules'>): string[] {
  const read = session.ioMappings.flatMap(({ inputMappings }) =>
    inputMappings.flatMap(({ topic }) => (topic ? [topic] : [])),
  );
  return [...new Set([...read, ...writtenTopics(session)])];
}

/**
 * Who writes what, of the sessions that run: two that write one topic take turns at it, and nothing
 * in either of them says so.
 * @param except the id of the one that asks
 */
export function runningWriters(
  sessions: readonly Session[],
  except: string,
): Map<string, readonly SessionRef[]> {
  const writers = new Map<string, readonly SessionRef[]>();
  for (const session of sessions) {
    if (session.id === except || !isAlive(session)) continue;
    const ref = { id: session.id, name: session.name || 'without a name' };
    for (const topic of writtenTopics(session)) {
      writers.set(topic, [...(writers.get(topic) ?? []), ref]);
    }
  }
  return writers;
}

/** Topics that a running session and other running ones write. */
export function sharedTopics(session: Session, sessions: readonly Session[]): SharedTopic[] {
  if (!isAlive(session)) return [];
  const writers = runningWriters(sessions, session.id);
  return [...writtenTopics(session)].flatMap((topic) => {
    const others = writers.get(topic);
    return others === undefined ? [] : [{ topic, others }];
  });
}

/** Who else writes, and what follows. */
export function sharedWords({ topic, others }: SharedTopic): string {
  const names = others.map(({ name }) => `"${name}"`).join(', ');
  const who = plural(
    others.length,
    `The session ${names} runs and writes`,
    `The sessions ${names} run and write`,
  );
  return `${who} ${topic}, too; the last record wins.`;
}
