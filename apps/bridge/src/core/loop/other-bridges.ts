import { AccessRole } from '@ubii/proto';
import { forgetFirst } from '../forget-first.ts';

const TAG = 'bridge to ';
/** Most bridges and masters that are remembered: far more than real installations have. */
const REMEMBERED = 1_000;

/** Tag of a bridge, by which others know which system it leads to. [BR-22] */
export function bridgeTag(system: string): string {
  return `${TAG}${system}`;
}

/** What is known of a client. */
export interface KnownClient {
  readonly id: string;
  readonly tags: readonly string[];
  readonly isGone: boolean;
  readonly isConnected: boolean;
  /** The master of the cluster that it is at; undefined without a cluster. */
  readonly masterId: string | undefined;
}

/** What a client may do, as the master says. */
export interface KnownRole {
  readonly clientId: string;
  readonly role: AccessRole;
}

/** Clients of the master, and of its cluster, that are bridges to the same system. What they publish came from there. [BR-22] */
export class OtherBridges {
  readonly #tag: string;
  /** Whether each is connected. */
  readonly #bridges = new Map<string, boolean>();
  /** Masters at which they are, or were. */
  readonly #masters = new Set<string>();
  /** What each says of its mappings: a text that is the same where they are. */
  readonly #mappings = new Map<string, string>();
  readonly #roles = new Map<string, AccessRole>();
  readonly #listeners = new Set<() => void>();

  constructor(system: string) {
    this.#tag = bridgeTag(system);
  }

  /** Calls the listener after each change. Returns a function that removes it. */
  onChange(listener: () => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  handleClient({ id, tags, isGone, isConnected, masterId }: KnownClient): void {
    if (!isGone && tags.includes(this.#tag)) {
      this.#bridges.set(id, isConnected);
      forgetFirst(this.#bridges, REMEMBERED);
      if (masterId !== undefined) this.#masters.add(masterId);
      forgetFirst(this.#masters, REMEMBERED);
    } else if (!this.#bridges.delete(id)) return;
    else {
      this.#mappings.delete(id);
      this.#roles.delete(id);
    }
    this.#emitChange();
  }

  /** A bridge, perhaps one that is not announced yet, says what it passes. */
  handleMappings(clientId: string, mappings: string): void {
    if (this.#mappings.get(clientId) === mappings) return;
    this.#mappings.set(clientId, mappings);
    forgetFirst(this.#mappings, REMEMBERED);
    if (this.#bridges.has(clientId)) this.#emitChange();
  }

  /** What those of `ids` may do. */
  handleRoles(roles: readonly KnownRole[]): void {
    for (const { clientId, role } of roles) {
      if (this.#bridges.has(clientId)) this.#roles.set(clientId, role);
    }
    this.#emitChange();
  }

  /** Ids of all that are here, connected or not. */
  get ids(): readonly string[] {
    return [...this.#bridges.keys()];
  }

  /** The connection to the master was lost: the next one lists the connected clients again. */
  handleLost(): void {
    for (const id of this.#bridges.keys()) this.#bridges.set(id, false);
  }

  has(clientId: string): boolean {
    return this.#bridges.has(clientId);
  }

  /** Whether it is a master at which one of them is, or was: what they mark with its id is known there. [BR-21] */
  isMaster(id: string): boolean {
    return this.#masters.has(id);
  }

  /**
   * Whether another one passes the same mappings: of those that are connected, one that may do more, or as much and has a
   * lesser id. Any client can say that it is a bridge; one with fewer rights does not make others stand by. [BR-24]
   */
  passesFor(ownId: string, mappings: string): boolean {
    const own = rankOf(this.#roles.get(ownId));
    return this.#connected().some((id) => {
      if (id === ownId || this.#mappings.get(id) !== mappings) return false;
      const rank = rankOf(this.#roles.get(id));
      return rank > own || (rank === own && id < ownId);
    });
  }

  /**
   * Resolves when all that are there are known: the bridge itself was announced, with the others, what each may do is known,
   * and each has announced its mappings.
   */
  untilKnown(ownId: string): Promise<void> {
    return new Promise((resolve) => {
      const look = (): void => {
        const connected = this.#connected();
        const isKnown = connected.every(
          (id) => this.#roles.has(id) && (id === ownId || this.#mappings.has(id)),
        );
        if (!connected.includes(ownId) || !isKnown) return;
        remove();
        resolve();
      };
      const remove = this.onChange(look);
      look();
    });
  }

  #connected(): readonly string[] {
    return [...this.#bridges].flatMap(([id, isConnected]) => (isConnected ? [id] : []));
  }

  #emitChange(): void {
    for (const listener of [...this.#listeners]) listener();
  }
}

/** Greater for more rights; clients that may not publish everywhere count the same as unknown ones. */
function rankOf(role: AccessRole | undefined): number {
  if (role === AccessRole.ACCESS_ROLE_ADMIN) return 2;
  return role === AccessRole.ACCESS_ROLE_PARTICIPANT ? 1 : 0;
}
