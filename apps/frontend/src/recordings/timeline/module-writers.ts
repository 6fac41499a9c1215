import { fromJson, type Session } from '@ubii/proto';

/** Names of the modules that write each topic in sessions, by topic. */
export function moduleWriters(
  sessions: readonly Pick<Session, 'ioMappings' | 'processingModules'>[],
): ReadonlyMap<string, string> {
  const writers = new Map<string, Set<string>>();
  for (const { ioMappings, processingModules } of sessions) {
    const names = new Map(processingModules.map(({ id, name }) => [id, name]));
    for (const { processingModuleId, outputMappings } of ioMappings) {
      const name = names.get(processingModuleId);
      if (!name) continue;
      for (const { topic } of outputMappings) {
        if (topic) writers.set(topic, (writers.get(topic) ?? new Set()).add(name));
      }
    }
  }
  return new Map([...writers].map(([topic, names]) => [topic, [...names].join(', ')]));
}

/** A recorded session; none when it cannot be read. @param session as JSON */
export function parseSession({ session }: { readonly session: string }): Session[] {
  try {
    return [fromJson('ubii.sessions.Session', JSON.parse(session))];
  } catch {
    return [];
  }
}
