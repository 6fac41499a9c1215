import { ServiceError, type Session as SessionMessage } from '@ubii/proto';
import { makerOf } from '../access/caller.ts';
import type { Core } from '../parts/core.ts';
import { requireRoom } from '../library/require-room.ts';
import type { Session } from '../sessions/session.ts';
import { quote } from '../texts/quote.ts';
import type { ServiceHandler } from './handler.ts';
import { requireElements } from './list-limits.ts';

/** `/services/session/database/save` [SE-21] */
export const saveSessions: ServiceHandler = async (core, request, { caller }) => {
  const messages = [
    ...(request.session === undefined ? [] : [request.session]),
    ...requireElements(core, request.sessionList?.elements ?? []),
  ];
  const elements: SessionMessage[] = [];
  for (const message of messages) {
    elements.push((await saveSession(core, message, makerOf(caller))).toMessage());
  }
  return { sessionList: { elements } };
};

/** `/services/session/database/delete` [SE-21] */
export const deleteStoredSession: ServiceHandler = async ({ processing }, request) => {
  const { sessions, sessionLibrary } = processing;
  const { id, name } = request.session!;
  // The id may be that of the session that was made of the stored one.
  const known = sessions.list().find((session) => session.id === id && session.isStored);
  const stored = sessionLibrary.require(id, known?.description.name ?? name);
  const made = sessions
    .list()
    .filter(({ isStored, description }) => isStored && description.name === stored.name);
  const running = made.find(({ isLive }) => isLive);
  if (running !== undefined) {
    throw new ServiceError(
      'failed_precondition',
      `The session ${quote(running.label)} is ${running.life}, and a running session cannot be deleted. Stop it first.`,
    );
  }
  await sessionLibrary.delete(stored.name);
  for (const session of made) sessions.setStored(session, false);
  return { success: { title: 'Success', message: 'The stored session is deleted.' } };
};

/** `/services/session/database/get` [SE-21] */
export const getStoredSession: ServiceHandler = ({ processing }, request) => {
  const { id, name } = request.session!;
  return { session: processing.sessionLibrary.require(id, name) };
};

/** `/services/session/database/get_list` and `local/get_list` [SE-21] */
export const listStoredSessions: ServiceHandler = ({ processing }) => ({
  sessionList: { elements: processing.sessionLibrary.list() },
});

/** `/services/session/database/online/get_list` [SE-25] */
export const listOnlineSessions: ServiceHandler = () => ({ sessionList: { elements: [] } });

/** Makes a session known, and stores it under its name. */
async function saveSession(core: Core, message: SessionMessage, maker: string): Promise<Session> {
  const { sessions, sessionLibrary } = core.processing;
  if (message.name === '') {
    throw new ServiceError(
      'invalid_argument',
      'The session has no name. Give it a name: sessions are stored by name.',
    );
  }
  requireRoom(core.limitWatch, sessionLibrary.stored, 'ubii.sessions.Session', message);
  const session = await sessions.toStore(message, maker);
  await sessionLibrary.save(session);
  for (const other of sessions.list()) {
    if (other.description.name === message.name) sessions.setStored(other, other === session);
  }
  return session;
}
