import { fromJson, type Session } from '@ubii/proto';

/**
 * A session without modules that the master does not have yet: its revision is 0. What is built and
 * runs is expected to run again after a restart of the master. [SE-24]
 */
export function blankSession(id: string, name: string): Session {
  const extension = { stored: true, startWithMaster: true };
  return fromJson('ubii.sessions.Session', { id, name, extension });
}
