import { ServiceError, type Session as SessionMessage } from '@ubii/proto';
import type { GrantId } from '../access/grant.ts';
import { grantOf } from '../access/caller.ts';
import { PARTICIPANTS, READERS } from '../access/roles.ts';
import type { Core } from '../areas/core.ts';
import { requireRoom } from '../library/require-room.ts';
import type { Session } from '../sessions/session.ts';
import { quote } from '../texts/quote.ts';
import { definer, success } from './define-service.ts';
import { requireElements } from './list-limits.ts';
import { nameOfSession, namesOfSession } from './sessions.ts';

type Context = Pick<Core, 'sessions' | 'sessionLibrary' | 'limitWatch'>;
const define = definer<keyof Context>();

const listStoredSessions = ({ sessionLibrary }: Context) => ({
  elements: sessionLibrary.list(),
});

/** Services on stored sessions. [SE-21] */
export const STORED_SESSION_SERVICES = [
  define('sessionDatabaseSave', {
    roles: PARTICIPANTS,
    // A session that is open is stored as it is where it is open. [CU-28]
    target: ({ session }) =>
      session === undefined ? {} : { session: { id: session.id, name: '' } },
    auditObject: (core, { session, sessionList }) =>
      session === undefined ? namesOf(sessionList?.elements ?? []) : namesOfSession(core, session),
    async handle(core, { session, sessionList }, { caller }) {
      const messages = [
        ...(session === undefined ? [] : [session]),
        ...requireElements(core, sessionList?.elements ?? []),
      ];
      const elements: SessionMessage[] = [];
      for (const message of messages) {
        elements.push((await saveSession(core, message, grantOf(caller))).toMessage());
      }
      return { elements };
    },
  }),
  define('sessionDatabaseDelete', {
    roles: PARTICIPANTS,
    target: (session) => ({ session }),
    auditObject: nameOfSession,
    async handle({ sessions, sessionLibrary }, { id, name }) {
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
      return success('The stored session is deleted.');
    },
  }),
  define('sessionDatabaseGet', {
    roles: READERS,
    handle: ({ sessionLibrary }, { id, name }) => sessionLibrary.require(id, name),
  }),
  define('sessionDatabaseGetList', { roles: READERS, handle: listStoredSessions }),
  define('sessionDatabaseLocalGetList', { roles: READERS, handle: listStoredSessions }),
  // [SE-25]
  define('sessionDatabaseOnlineGetList', { roles: READERS, handle: () => ({ elements: [] }) }),
];

function namesOf(sessions: readonly SessionMessage[]): string {
  const shown = sessions.slice(0, 5).map(({ name }) => name.slice(0, 40));
  return sessions.length > shown.length ? `${shown.join(', ')}, …` : shown.join(', ');
}

/** Makes a session known, and stores it under its name. */
async function saveSession(
  core: Context,
  message: SessionMessage,
  maker: GrantId | undefined,
): Promise<Session> {
  const { sessions, sessionLibrary } = core;
  if (message.name === '') {
    throw new ServiceError(
      'invalid_argument',
      'The session has no name. Give it a name: sessions are stored by name.',
    );
  }
  requireRoom(core.limitWatch, sessionLibrary.stored, 'ubii.sessions.Session', message);
  const session = await sessions.toStore(message, maker);
  try {
    await sessionLibrary.save(session);
  } catch (error) {
    sessions.setStored(session, sessionLibrary.get(message.name) !== undefined);
    throw error;
  }
  for (const other of sessions.list()) {
    if (other.description.name === message.name) sessions.setStored(other, other === session);
  }
  return session;
}
