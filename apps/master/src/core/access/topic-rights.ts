import { clientTopic, globToRegExpSource, identifyTopic, preflightTopic } from '@ubii/proto';
import type { CompiledPattern, PatternCompiler } from '../ports/pattern-compiler.ts';
import type { Grant } from './grant.ts';
import type { Role } from './roles.ts';

/** Where a client may publish. In its place, undefined: everywhere [AC-24]. */
export interface PublishRights {
  mayPublish(topic: string): boolean;
  /** Whether it may say besides, on the topic for that, that it is gone itself. */
  readonly maySayFarewell: boolean;
}

/** What a client may receive. In its place, undefined: everything [AC-25]. */
export interface ReadRights {
  mayRead(topic: string): boolean;
}

/** What the rights of participants are found by. */
export interface Namespaces {
  /** Whether this is the id of a registered client. */
  isClient(id: string): boolean;
  /** Whether a component of this client subscribes to the topic. */
  isInputOf(clientId: string, topic: string): boolean;
}

/** Topics of which an answer is remembered, for each player. */
const MAX_REMEMBERED = 1_024;

/** A client's rights on topics. */
export interface TopicRights {
  readonly publish: PublishRights | undefined;
  readonly read: ReadRights | undefined;
}

/** The rights of a client with this role. @param grant the one it joined with */
export function topicRightsOf(
  clientId: string,
  role: Role,
  grant: Grant | undefined,
  namespaces: Namespaces,
  patterns: PatternCompiler,
): TopicRights {
  switch (role) {
    case 'admin':
      return { publish: undefined, read: undefined };
    case 'participant':
      return { publish: new ParticipantRights(clientId, namespaces), read: undefined };
    case 'viewer':
      return { publish: viewerPublishing(clientId), read: undefined };
    case 'player':
    case 'none':
      return playerRights(clientId, role === 'none' ? undefined : grant, patterns);
  }
}

/** Everywhere, but in the namespace of another client only where that client listens. */
class ParticipantRights implements PublishRights {
  /** It may, as on other topics that are nobody's. */
  readonly maySayFarewell = false;
  readonly #clientId: string;
  readonly #own: string;
  readonly #namespaces: Namespaces;

  constructor(clientId: string, namespaces: Namespaces) {
    this.#clientId = clientId;
    this.#own = `/${clientId}/`;
    this.#namespaces = namespaces;
  }

  mayPublish(topic: string): boolean {
    if (topic.startsWith(this.#own)) return true;
    const end = topic.indexOf('/', 1);
    if (end < 0) return true;
    const owner = topic.slice(topic.startsWith('/') ? 1 : 0, end);
    return (
      owner === this.#clientId ||
      !this.#namespaces.isClient(owner) ||
      topic === identifyTopic(owner) ||
      this.#namespaces.isInputOf(owner, topic)
    );
  }
}

/** What its preflight found, for the host [AC-30]; nothing else. */
function viewerPublishing(clientId: string): PublishRights {
  const own = preflightTopic(clientId);
  return { mayPublish: (topic) => topic === own, maySayFarewell: false };
}

function playerRights(
  clientId: string,
  grant: Grant | undefined,
  patterns: PatternCompiler,
): TopicRights {
  const own = `/${clientId}/`;
  // Existing programs look for the orientation of a phone without a slash in front.
  const bare = `${clientId}/`;
  const self = clientTopic(clientId);
  const writes = new Globs(grant?.writeTopics ?? [], patterns);
  const reads = new Globs(grant?.readTopics ?? [], patterns);
  const isOwn = (topic: string): boolean => topic.startsWith(own) || topic.startsWith(bare);
  return {
    publish: { mayPublish: (topic) => isOwn(topic) || writes.match(topic), maySayFarewell: true },
    read: { mayRead: (topic) => isOwn(topic) || topic === self || reads.match(topic) },
  };
}

/** Globs, with what was found for the topics of late [AC-28]. */
class Globs {
  readonly #patterns: readonly CompiledPattern[];
  readonly #found = new Map<string, boolean>();

  constructor(globs: readonly string[], patterns: PatternCompiler) {
    this.#patterns = globs.map((glob) => patterns.compile(globToRegExpSource(glob)));
  }

  match(topic: string): boolean {
    if (this.#patterns.length === 0) return false;
    const known = this.#found.get(topic);
    if (known !== undefined) return known;
    const matches = this.#patterns.some((pattern) => pattern.test(topic));
    if (this.#found.size >= MAX_REMEMBERED) this.#found.clear();
    this.#found.set(topic, matches);
    return matches;
  }
}
