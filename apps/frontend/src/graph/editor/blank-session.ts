import { fromJson, type Session } from '@ubii/proto';

/** A session without modules that the master does not have yet: its revision is 0. */
export function blankSession(id: string, name: string): Session {
  return fromJson('ubii.sessions.Session', { id, name, extension: { stored: true } });
}
