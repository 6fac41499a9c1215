import type { Session as SessionMessage } from '@ubii/proto';
import { grantOf } from '../access/caller.ts';
import { PARTICIPANTS, READERS } from '../access/roles.ts';
import type { Core } from '../areas/core.ts';
import { definer, success } from './define-service.ts';

type Context = Pick<Core, 'sessions' | 'sessionLibrary' | 'foreignSessions'>;
const define = definer<keyof Context>();

/** Of every service that is about a session. */
const ABOUT = { target: (session: SessionMessage) => ({ session }) };
/** Of every service that changes sessions. */
const CHANGE = { ...ABOUT, roles: PARTICIPANTS, auditObject: nameOfSession };

/** Services on sessions that the master knows, running or not. */
export const SESSION_SERVICES = [
  // [SE-1]
  define('sessionRuntimeAdd', {
    ...CHANGE,
    async handle(context, message, { caller }) {
      const session = await context.sessions.add(message, grantOf(caller));
      return whenRemembered(context, session.id, session.toMessage());
    },
  }),
  define('sessionRuntimeGet', {
    ...ABOUT,
    roles: READERS,
    handle({ sessions, sessionLibrary }, { id }) {
      // Reading changes nothing: what is only stored is answered as it is stored [SE-27].
      const stored = sessions.isOpen(id) ? undefined : sessionLibrary.toOpen(id);
      if (stored !== undefined) return stored;
      const session = sessions.require(id);
      sessions.recheck(session);
      return session.toMessage();
    },
  }),
  define('sessionRuntimeGetList', {
    roles: READERS,
    // [CU-30]
    handle: ({ sessions, foreignSessions }) => ({
      elements: [
        ...sessions.list().map((session) => session.toMessage()),
        ...foreignSessions.list().filter(({ id }) => !sessions.isOpen(id)),
      ],
    }),
  }),
  // [SE-11]
  define('sessionRuntimeStart', {
    ...CHANGE,
    async handle(context, message, { caller }) {
      const session = await context.sessions.start(message, grantOf(caller));
      return whenRemembered(context, session.id, session.toMessage());
    },
  }),
  // [SE-13]
  define('sessionRuntimeStop', {
    ...CHANGE,
    async handle(context, { id }) {
      const { sessions } = context;
      sessions.stop(await sessions.find(id));
      return whenRemembered(context, id, success('The session is stopping.'));
    },
  }),
  // [SE-15]
  define('sessionRuntimeUpdate', {
    ...CHANGE,
    auditObject: namesOfSession,
    async handle(context, message, { caller }) {
      const { sessions } = context;
      const session = await sessions.find(message.id);
      await sessions.update(session, message, grantOf(caller));
      return whenRemembered(context, session.id, session.toMessage());
    },
  }),
  // [SE-16]
  define('sessionRuntimeRemove', {
    ...CHANGE,
    handle(context, { id }) {
      const { sessions } = context;
      sessions.remove(sessions.require(id));
      return whenRemembered(context, id, success('The session is removed.'));
    },
  }),
  // [SE-14]
  define('sessionPause', {
    ...CHANGE,
    async handle({ sessions }, { id }) {
      const session = await sessions.find(id);
      sessions.pause(session);
      return session.toMessage();
    },
  }),
  // [SE-14]
  define('sessionResume', {
    ...CHANGE,
    async handle({ sessions }, { id }) {
      const session = await sessions.find(id);
      sessions.resume(session);
      return session.toMessage();
    },
  }),
];

/** The name of a session, or what is known in place of it. */
export function nameOfSession(
  { sessions }: Pick<Core, 'sessions'>,
  { id, name }: Pick<SessionMessage, 'id' | 'name'>,
): string {
  const known = sessions.list().find((session) => session.id === id);
  return known?.description.name || name || id;
}

/** The same for a change that may give it another name: `Session → Arm lights`. */
export function namesOfSession(
  core: Pick<Core, 'sessions'>,
  session: Pick<SessionMessage, 'id' | 'name'>,
): string {
  const before = nameOfSession(core, session);
  return session.name === '' || session.name === before ? before : `${before} → ${session.name}`;
}

/** The reply, once it is on the disk what starts with the next master: what was answered, stands [SE-24]. */
async function whenRemembered<R>(
  { sessionLibrary }: Pick<Core, 'sessionLibrary'>,
  id: string,
  reply: R,
): Promise<R> {
  await sessionLibrary.remembered(id);
  return reply;
}
