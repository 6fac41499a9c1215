import { fromJson, type ProcessingModule, type Session } from '@ubii/proto';

/**
 * A session that the master does not have yet: its revision is 0. What is built and runs is expected to
 * run again after a restart of the master. [SE-24]
 * @param modules that it begins with
 */
export function blankSession(
  id: string,
  name: string,
  modules: readonly ProcessingModule[] = [],
): Session {
  const extension = { stored: true, startWithMaster: true };
  const session = fromJson('ubii.sessions.Session', { id, name, extension });
  return { ...session, processingModules: [...modules] };
}
