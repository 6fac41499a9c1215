import type { Session } from '@ubii/proto';

type Mapped = Pick<Session, 'id' | 'name' | 'ioMappings'>;

/** Returns the sessions with inputs that read a topic of a client, such as those of its smart device. */
export function sessionsReading<S extends Mapped>(
  sessions: readonly S[],
  clientId: string,
): readonly S[] {
  if (clientId === '') return [];
  return sessions.filter(({ ioMappings }) =>
    ioMappings.some(({ inputMappings }) =>
      // Some topics of a device have no leading slash.
      inputMappings.some(({ topic }) => topic?.replace(/^\//, '').startsWith(`${clientId}/`)),
    ),
  );
}
