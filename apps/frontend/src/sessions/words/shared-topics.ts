import type { Session } from '@ubii/proto';
import { plural } from '@ubii/words';
import { isAlive } from '../state/session-state.ts';

/** Reference to another session. */
export interface SessionRef {
  readonly id: string;
  readonly name: string;
}

/** Topic that another session writes, too. */
export interface SharedTopic {
  readonly topic: string;
  readonly others: readonly SessionRef[];
}

/** Returns the topics that the modules of a session write. */
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

/** Returns the topics that the modules of a session read or write, without duplicates. */
export function mappedTopics(session: Pick<Session, 'ioMappings' | 'processingModules'>): string[] {
  const read = session.ioMappings.flatMap(({ inputMappings }) =>
    inputMappings.flatMap(({ topic }) => (topic ? [topic] : [])),
  );
  return [...new Set([...read, ...writtenTopics(session)])];
}

/**
 * Returns the running sessions by the topics that they write: two sessions that write one topic alternate, and neither
 * reports it.
 * @param except id of a session to omit
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

/** Returns the topics that a running session and other running ones write. */
export function sharedTopics(session: Session, sessions: readonly Session[]): SharedTopic[] {
  if (!isAlive(session)) return [];
  const writers = runningWriters(sessions, session.id);
  return [...writtenTopics(session)].flatMap((topic) => {
    const others = writers.get(topic);
    return others === undefined ? [] : [{ topic, others }];
  });
}

/** Describes the other writers and the consequence. */
export function sharedWords({ topic, others }: SharedTopic): string {
  const names = others.map(({ name }) => `"${name}"`).join(', ');
  const who = plural(
    others.length,
    `The session ${names} runs and writes`,
    `The sessions ${names} run and write`,
  );
  return `${who} ${topic}, too; the last record wins.`;
}
