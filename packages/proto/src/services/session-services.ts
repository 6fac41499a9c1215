import { withoutPayload, withPayload } from './define-service.ts';

/** Services about sessions: stored and running ones. */
export const SESSION_SERVICES = {
  sessionDatabaseSave: withPayload(
    '/services/session/database/save',
    'session',
    'sessionList',
    'Stores sessions.',
    { constant: 'SESSION_DATABASE_SAVE', alternativeRequest: 'sessionList' },
  ),
  sessionDatabaseDelete: withPayload(
    '/services/session/database/delete',
    'session',
    'success',
    'Deletes the stored session with the given id.',
    { constant: 'SESSION_DATABASE_DELETE' },
  ),
  sessionDatabaseGet: withPayload(
    '/services/session/database/get',
    'session',
    'session',
    'Returns the stored session with the given id.',
    { constant: 'SESSION_DATABASE_GET' },
  ),
  sessionDatabaseGetList: withoutPayload(
    '/services/session/database/get_list',
    'sessionList',
    'Lists the stored sessions.',
    { constant: 'SESSION_DATABASE_GET_LIST' },
  ),
  sessionDatabaseOnlineGetList: withoutPayload(
    '/services/session/database/online/get_list',
    'sessionList',
    'Lists the sessions of the online library.',
    { constant: 'SESSION_DATABASE_ONLINE_GET_LIST' },
  ),
  sessionDatabaseLocalGetList: withoutPayload(
    '/services/session/database/local/get_list',
    'sessionList',
    'Lists the sessions stored on the master.',
    { constant: 'SESSION_DATABASE_LOCAL_GET_LIST' },
  ),
  sessionRuntimeAdd: withPayload(
    '/services/session/runtime/add',
    'session',
    'session',
    'Creates a session without starting it and gives it an id.',
    { constant: 'SESSION_RUNTIME_ADD' },
  ),
  sessionRuntimeRemove: withPayload(
    '/services/session/runtime/remove',
    'session',
    'success',
    'Stops and deletes a session.',
    { constant: 'SESSION_RUNTIME_REMOVE' },
  ),
  sessionRuntimeGet: withPayload(
    '/services/session/runtime/get',
    'session',
    'session',
    'Returns the session with the given id.',
    { constant: 'SESSION_RUNTIME_GET' },
  ),
  sessionRuntimeGetList: withoutPayload(
    '/services/session/runtime/get_list',
    'sessionList',
    'Lists the sessions, stopped ones included.',
    { constant: 'SESSION_RUNTIME_GET_LIST' },
  ),
  sessionRuntimeStart: withPayload(
    '/services/session/runtime/start',
    'session',
    'session',
    'Starts a session: an existing one by id or name, or the given one.',
    { constant: 'SESSION_RUNTIME_START' },
  ),
  sessionRuntimeStop: withPayload(
    '/services/session/runtime/stop',
    'session',
    'success',
    'Stops the session with the given id.',
    { constant: 'SESSION_RUNTIME_STOP' },
  ),
  sessionRuntimeUpdate: withPayload(
    '/services/session/runtime/update',
    'session',
    'session',
    'Replaces the specification of a session.',
    { constant: 'SESSION_RUNTIME_UPDATE' },
  ),
} as const;
