import type { CompiledPattern, PatternCompiler } from '@ubii/patterns';
import {
  clientTopic,
  globToRegExpSource,
  identifyTopic,
  isMasterTopic,
  preflightTopic,
} from '@ubii/proto';
import type { Grant } from './grant.ts';
import { TOPIC_RIGHTS, type TopicKind, type TopicRight } from './rights-table.ts';
import type { PublishRights, ReadRights } from '../topics/rights.ts';
import type { Role } from './roles.ts';

/** Dependencies of the rights of participants. */
export interface Namespaces {
  /** Ids of registered clients. */
  readonly clients: { has(id: string): boolean };
  /** Whether a component of this client subscribes to the topic. */
  readonly devices: { isInputOf(clientId: string, topic: string): boolean };
}

/** Topics of which an answer is remembered, for each player. */
const MAX_REMEMBERED = 1_024;

/** Kinds that do not depend on the role: the master publishes there, and players by their invitation. */
const MASTERS_KINDS: readonly TopicKind[] = ['ownState', 'master', 'granted'];

/** Kinds that are distinguished by who is registered: only where it matters, as it costs a search. */
const KINDS_OF_OTHERS: readonly TopicKind[] = ['identify', 'inputOfOther', 'other', 'elsewhere'];

type Direction = 'publish' | 'receive';

/** Kinds on which a role has the right: one set for all its clients. */
const KINDS = { publish: kindsByRole('publish'), receive: kindsByRole('receive') };

/** A client's rights on topics. */
export interface TopicRights {
  readonly publish: PublishRights | undefined;
  readonly read: ReadRights | undefined;
}

/** The rights of a client with this role, by the table. @param grant the one it joined with */
export function topicRightsOf(
  clientId: string,
  role: Role,
  grant: Grant | undefined,
  namespaces: Namespaces,
  patterns: PatternCompiler,
): TopicRights {
  const rightsIn = (direction: Direction, globs: readonly string[]): Rights =>
    new Rights(
      clientId,
      KINDS[direction][role],
      new Globs(role === 'player' ? globs : [], patterns),
      namespaces,
    );
  const publish = KINDS.publish[role];
  const receive = KINDS.receive[role];
  return {
    publish: hasAll(publish, MASTERS_KINDS)
      ? undefined
      : rightsIn('publish', grant?.writeTopics ?? []),
    read: hasAll(receive, ['granted']) ? undefined : rightsIn('receive', grant?.readTopics ?? []),
  };
}

function kindsFor(role: Role, direction: Direction): ReadonlySet<TopicKind> {
  const rows = Object.entries<TopicRight>(TOPIC_RIGHTS);
  const allowed = rows.filter(([, row]) => row[direction].some((given) => given === role));
  return new Set(allowed.map(([kind]) => kind as TopicKind));
}

function kindsByRole(direction: Direction): Readonly<Record<Role, ReadonlySet<TopicKind>>> {
  return {
    none: kindsFor('none', direction),
    admin: kindsFor('admin', direction),
    participant: kindsFor('participant', direction),
    player: kindsFor('player', direction),
    viewer: kindsFor('viewer', direction),
  };
}

/** Whether every kind is among these, but for those that do not count. */
function hasAll(kinds: ReadonlySet<TopicKind>, except: readonly TopicKind[]): boolean {
  return Object.keys(TOPIC_RIGHTS).every(
    (kind) => kinds.has(kind as TopicKind) || except.includes(kind as TopicKind),
  );
}

/** Returns the id of the registered client in whose namespace a topic is; undefined for all other topics. [AC-24] */
export function namespaceOwner(topic: string, clients: Namespaces['clients']): string | undefined {
  const end = topic.indexOf('/', 1);
  if (end < 0) return undefined;
  const owner = topic.slice(topic.startsWith('/') ? 1 : 0, end);
  return clients.has(owner) ? owner : undefined;
}

/** Rights of one client in one direction, from the table. */
class Rights implements PublishRights, ReadRights {
  readonly maySayFarewell: boolean;
  readonly #kinds: ReadonlySet<TopicKind>;
  readonly #granted: Globs;
  readonly #namespaces: Namespaces;
  readonly #own: string;
  /** Existing programs look for the orientation of a phone without a slash in front. */
  readonly #bare: string;
  readonly #preflight: string;
  readonly #state: string;
  readonly #tellsOthersApart: boolean;

  constructor(
    clientId: string,
    kinds: ReadonlySet<TopicKind>,
    granted: Globs,
    namespaces: Namespaces,
  ) {
    this.#kinds = kinds;
    this.#granted = granted;
    this.#namespaces = namespaces;
    this.#own = `/${clientId}/`;
    this.#bare = `${clientId}/`;
    this.#preflight = preflightTopic(clientId);
    this.#state = clientTopic(clientId);
    const ofOthers = new Set(KINDS_OF_OTHERS.map((kind) => kinds.has(kind)));
    this.#tellsOthersApart = ofOthers.size > 1;
    // Clients that may publish everywhere need no permission for this topic.
    this.maySayFarewell = kinds.has('farewell') && !kinds.has('elsewhere');
  }

  mayPublish(topic: string): boolean {
    return this.#kinds.has(this.#kindOf(topic));
  }

  mayRead(topic: string): boolean {
    return this.#kinds.has(this.#kindOf(topic));
  }

  /** The kind of a topic as far as the topic tells it: `farewell` depends on the value. */
  #kindOf(topic: string): TopicKind {
    if (topic.startsWith(this.#own)) return topic === this.#preflight ? 'ownPreflight' : 'own';
    if (topic.startsWith(this.#bare)) return 'own';
    if (topic === this.#state) return 'ownState';
    if (this.#granted.match(topic)) return 'granted';
    if (isMasterTopic(topic)) return 'master';
    return this.#tellsOthersApart ? this.#kindOfOthers(topic) : 'elsewhere';
  }

  #kindOfOthers(topic: string): TopicKind {
    const { clients, devices } = this.#namespaces;
    const owner = namespaceOwner(topic, clients);
    if (owner === undefined) return 'elsewhere';
    if (topic === identifyTopic(owner)) return 'identify';
    return devices.isInputOf(owner, topic) ? 'inputOfOther' : 'other';
  }
}

/** Globs, with cached results for recent topics [AC-28]. */
class Globs {
  readonly #patterns: readonly CompiledPattern[];
  /** Undefined before the first: most invitations give no further topics, and clients stay while they are away. */
  #found: Map<string, boolean> | undefined = undefined;

  constructor(globs: readonly string[], patterns: PatternCompiler) {
    this.#patterns = globs.map((glob) => patterns.compile(globToRegExpSource(glob)));
  }

  match(topic: string): boolean {
    if (this.#patterns.length === 0) return false;
    const found = (this.#found ??= new Map());
    const known = found.get(topic);
    if (known !== undefined) return known;
    const matches = this.#patterns.some((pattern) => pattern.test(topic));
    if (found.size >= MAX_REMEMBERED) found.clear();
    found.set(topic, matches);
    return matches;
  }
}
