import { fromJson, type Session } from '@ubii/proto';

/** Names of the modules that write each topic in recorded sessions, by topic. @param sessions as JSON */
export function moduleWriters(
  sessions: readonly { readonly session: string }[],
): ReadonlyMap<string, string> {
  const writers = new Map<string, Set<string>>();
  for (const { ioMappings, processingModules } of sessions.flatMap(parsed)) {
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

/** None when a session cannot be read. */
function parsed({ session }: { readonly session: string }): Session[] {
  try {
    return [fromJson('ubii.sessions.Session', JSON.parse(session))];
  } catch {
    return [];
  }
}
