import type { Session as SessionMessage, ServiceRequest } from '@ubii/proto';
import { makerOf } from '../access/caller.ts';
import type { Core } from '../parts/core.ts';
import type { Session } from '../sessions/session.ts';
import type { ServiceHandler } from './handler.ts';

/** `/services/session/runtime/add` [SE-1] */
export const addSession: ServiceHandler = async ({ processing }, request, { caller }) => ({
  session: (await processing.sessions.add(payloadOf(request), makerOf(caller))).toMessage(),
});

/** `/services/session/runtime/get` */
export const getSession: ServiceHandler = ({ processing }, request) => {
  const { sessions, sessionLibrary } = processing;
  const { id } = payloadOf(request);
  // Reading changes nothing: what is only stored is answered as it is stored [SE-27].
  const stored = sessions.isOpen(id) ? undefined : sessionLibrary.toOpen(id);
  if (stored !== undefined) return { session: stored };
  const session = sessions.require(id);
  sessions.recheck(session);
  return { session: session.toMessage() };
};

/** `/services/session/runtime/get_list` */
export const listSessions: ServiceHandler = ({ processing }) => ({
  sessionList: { elements: processing.sessions.list().map((session) => session.toMessage()) },
});

/** `/services/session/runtime/start` [SE-11] */
export const startSession: ServiceHandler = async ({ processing }, request, { caller }) => ({
  session: (await processing.sessions.start(payloadOf(request), makerOf(caller))).toMessage(),
});

/** `/services/session/runtime/stop` [SE-13] */
export const stopSession: ServiceHandler = async (core, request) => {
  const session = await known(core, request);
  core.processing.sessions.stop(session);
  return { success: { title: 'Success', message: 'The session is stopping.' } };
};

/** `/services/session/runtime/update` [SE-15] */
export const updateSession: ServiceHandler = async (core, request, { caller }) => {
  const session = await known(core, request);
  await core.processing.sessions.update(session, payloadOf(request), makerOf(caller));
  return { session: session.toMessage() };
};

/** `/services/session/runtime/remove` [SE-16] */
export const removeSession: ServiceHandler = (core, request) => {
  const { sessions } = core.processing;
  sessions.remove(sessions.require(payloadOf(request).id));
  return { success: { title: 'Success', message: 'The session is removed.' } };
};

/** `/services/ubii/session_pause` [SE-14] */
export const pauseSession: ServiceHandler = async (core, request) => {
  const session = await known(core, request);
  core.processing.sessions.pause(session);
  return { session: session.toMessage() };
};

/** `/services/ubii/session_resume` [SE-14] */
export const resumeSession: ServiceHandler = async (core, request) => {
  const session = await known(core, request);
  core.processing.sessions.resume(session);
  return { session: session.toMessage() };
};

/** The session of the request; a stored one is opened [SE-27]. */
function known({ processing }: Core, request: ServiceRequest): Promise<Session> {
  return processing.sessions.find(payloadOf(request).id);
}

function payloadOf(request: ServiceRequest): SessionMessage {
  return request.session!;
}
