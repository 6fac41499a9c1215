import { JOINED, PARTICIPANTS, PUBLISHERS, READERS, type GivenRole, type Role } from './roles.ts';

/** Roles of callers, from the fewest rights to the most; `none` is a stranger. */
export const ROLES_BY_RIGHTS: readonly Role[] = [
  'none',
  'viewer',
  'player',
  'participant',
  'admin',
];

/** Roles that may call a service. `anyone` includes strangers. Each service is defined with its rights in `core/services`. */
export interface ServiceRight {
  readonly roles: readonly GivenRole[] | 'anyone';
  /** Its request names the client that asks, which has to be the caller [AC-22]. */
  readonly actsForClient: boolean;
  /** The service affects other clients, so that its calls are audited [EX-90]. */
  readonly audited: boolean;
}

/** Roles that may publish, and roles that may receive, one kind of topic. */
export interface TopicRight {
  /** The topics, as `docs/security.md` shows them. */
  readonly topics: string;
  readonly publish: readonly GivenRole[];
  readonly receive: readonly GivenRole[];
}

/** Every kind of topic. A topic is of the first kind that fits [AC-24] [AC-25] [TD-16]. */
export const TOPIC_RIGHTS = {
  ownState: { topics: '`/ubii/client/<own id>`', publish: [], receive: JOINED },
  granted: {
    topics: 'topics that the invitation of a player names; none of the next row to publish',
    publish: ['player'],
    receive: ['player'],
  },
  master: { topics: 'others in `/info/`, `/ubii/`', publish: [], receive: READERS },
  ownPreflight: { topics: '`/<own id>/preflight`', publish: JOINED, receive: JOINED },
  own: {
    topics: 'others in `/<own id>/`, `<own id>/`',
    publish: PUBLISHERS,
    receive: JOINED,
  },
  farewell: {
    topics: '`removeClient` with the own id as a string',
    publish: PUBLISHERS,
    receive: READERS,
  },
  identify: {
    topics: '`/<id of another client>/identify`',
    publish: PARTICIPANTS,
    receive: READERS,
  },
  inputOfOther: {
    topics: 'others in `/<id of another client>/` to which a component of that client subscribes',
    publish: PARTICIPANTS,
    receive: READERS,
  },
  other: {
    topics: 'others in `/<id of another client>/`, `<id of another client>/`',
    publish: ['admin'],
    receive: READERS,
  },
  elsewhere: { topics: 'all others', publish: PARTICIPANTS, receive: READERS },
} as const satisfies Readonly<Record<string, TopicRight>>;

/** A kind of topic, as seen by one client. */
export type TopicKind = keyof typeof TOPIC_RIGHTS;

/** Roles that may read a path. */
export interface PathRight {
  readonly method: 'GET' | 'POST';
  readonly path: string;
  /** Content of the path, as in `docs/security.md`. */
  readonly content: string;
  readonly roles: readonly Role[];
}

/** Every path that the master answers over HTTP [AC-5]. A path that is not here is not served. */
export const PATH_RIGHTS: readonly PathRight[] = [
  path('GET', '/*', 'files and pages of the frontend'),
  path('GET', '/asset-sets/:name/manifest.json', 'files of an asset set, with size and hash'),
  path('GET', '/asset-sets/:name/:hash/*', 'a file of an asset set'),
  path('GET', '/ca.pem', 'certificate of the authority'),
  path('GET', '/ca.crt', 'the same, for Android and Windows'),
  path('GET', '/ca.mobileconfig', 'the same, for iOS'),
  path('GET', '/ca.json', 'its fingerprint and end'),
  path('GET', '/sdk', 'page about the client library'),
  path('GET', '/sdk/*', 'a file of the client library'),
  path('GET', '/health', 'whether the master runs; id, name and version for those who joined'),
  path('GET', '/recordings/:id.mcap', 'file of a recording', PARTICIPANTS),
  path('POST', '/recordings', 'uploads a recording', PARTICIPANTS),
  path('GET', '/metrics', 'counters for Prometheus', READERS),
  path('POST', '/services', 'services, each with its own row above'),
  path('POST', '/services/json', 'the same, as JSON'),
  path('POST', '/services/binary', 'the same, as protobuf'),
];

/** Roles that may open a WebSocket. */
export interface SocketRight {
  readonly path: string;
  /** Content of the WebSocket, as in `docs/security.md`. */
  readonly content: string;
  readonly roles: readonly Role[];
}

/** Every kind of WebSocket [AC-27] [AC-29]. */
export const SOCKET_RIGHTS = {
  preflight: {
    path: '/preflight',
    content: 'the time of the master, 16 times at most',
    roles: ROLES_BY_RIGHTS,
  },
  topicData: {
    path: '/*',
    content: 'topic data of the client that the caller proves to be',
    roles: JOINED,
  },
} as const satisfies Readonly<Record<string, SocketRight>>;

/** True when a caller with this role may call the service for itself [AC-21]. */
export function mayCall({ roles }: Pick<ServiceRight, 'roles'>, role: Role): boolean {
  return roles === 'anyone' || roles.some((allowed) => allowed === role);
}

function path(
  method: PathRight['method'],
  at: string,
  content: string,
  roles: readonly Role[] = ROLES_BY_RIGHTS,
): PathRight {
  return { method, path: at, content, roles };
}
