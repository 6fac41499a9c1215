import { fromJson, type ProcessingModule, type Session } from '@ubii/proto';

/**
 * Returns a new session, with revision 0, that the master does not have yet. It is kept and restarted with the master.
 * [SE-24]
 * @param modules initial modules
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
