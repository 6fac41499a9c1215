import type { Cancel, Clock } from '@ubii/timing';
import type { Caller } from '../access/caller.ts';
import type { LimitName, Limits } from '../limits/index.ts';
import type { LimitWatch } from '../counters/limit-watch.ts';
import { KnownAddresses } from './known-addresses.ts';
import { OpenConnection, type ConnectionKind, type TransportPeer } from './open-connection.ts';

/** Part of `connections` that is kept for this machine: one in so many. */
const KEPT_FOR_THIS_MACHINE = 8;
/** A younger connection is not closed for another one of the same address: its first request may still come. */
const GRACE_MS = 3_000;
/** Interval of checks for connections without a request, milliseconds. */
const SWEEP_INTERVAL_MS = 1_000;

/** Connections of one address of another machine that are not of clients, the oldest first. */
interface AddressGroup {
  readonly address: string;
  readonly network: string;
  readonly open: Set<OpenConnection>;
  strangers: number;
}

/** One limit that a new connection meets. */
interface Level {
  readonly limit: LimitName;
  readonly used: number;
  readonly max: number;
  /** Connection to close when the limit is reached; undefined: the new one. */
  readonly findVictim: () => OpenConnection | undefined;
}

/**
 * All connections to all ports. Joined callers and local callers get a connection,
 * however many strangers connect: these are closed first, those of the address with most of them before
 * others. [AC-60] [AC-61] [AC-62]
 */
export class Connections {
  readonly #clock: Clock;
  readonly #limitWatch: LimitWatch;
  readonly #limits: Limits;
  readonly #known: KnownAddresses;
  readonly #open = new Set<OpenConnection>();
  /** Those of which no request has come, the oldest first. */
  readonly #silent = new Set<OpenConnection>();
  readonly #groups = new Map<string, AddressGroup>();
  readonly #byNetwork = new Map<string, number>();
  #remote = 0;
  #strangers = 0;
  readonly #cancel: Cancel;

  constructor(clock: Clock, limitWatch: LimitWatch) {
    this.#clock = clock;
    this.#limitWatch = limitWatch;
    this.#limits = limitWatch.limits;
    this.#known = new KnownAddresses(clock, this.#limits.unavailableRetentionMs);
    this.#cancel = clock.every(SWEEP_INTERVAL_MS, () => this.#sweep());
  }

  get size(): number {
    return this.#open.size;
  }

  /** Number of connections of strangers. */
  get strangers(): number {
    return this.#strangers;
  }

  /** Most connections of one address that are not of clients. */
  get mostOfAddress(): number {
    return Math.max(0, ...[...this.#groups.values()].map(({ open }) => open.size));
  }

  /** Most connections of one network that are not of clients. */
  get mostOfNetwork(): number {
    return Math.max(0, ...this.#byNetwork.values());
  }

  /**
   * Takes a connection that was just made.
   *
   * @param cut closes it at once, silently
   * @returns undefined when there is no room: it is to be cut
   */
  admit(peer: TransportPeer, cut: () => void): OpenConnection | undefined {
    const kind = peer.isLocal ? 'local' : this.#known.has(peer.address) ? 'known' : 'stranger';
    const connection = new OpenConnection({
      peer,
      kind,
      cut,
      openedMs: this.#clock.monotonicMs(),
      keeper: this,
    });
    if (!this.#hasRoom(connection)) return undefined;
    this.#open.add(connection);
    this.#silent.add(connection);
    this.#enter(connection);
    return connection;
  }

  /** Ends every timer. */
  close(): void {
    this.#cancel();
  }

  /** A request has come on it. For `OpenConnection`. */
  handleRequest(connection: OpenConnection): void {
    this.#silent.delete(connection);
  }

  /** A request on it identified its caller. For `OpenConnection`. */
  handleCaller(connection: OpenConnection, caller: Caller['kind']): void {
    const { kind, peer } = connection;
    if (kind === 'local' ? caller === 'local' : caller === 'stranger') return;
    // A proxy of this machine brings others: they have no part in what is kept for it.
    if (caller !== 'stranger' && !peer.isLocal) this.#known.add(peer.address);
    this.#become(connection, caller === 'stranger' ? 'stranger' : 'member');
    // There was room for it as what it was; now there may be one stranger too many.
    if (this.#strangers > this.#limits.connectionsOfStrangers) {
      this.#limitWatch.count('connectionsOfStrangers');
      connection.end();
    }
  }

  /** It carries the topic data of a client from now on. For `OpenConnection`. */
  handleClient(connection: OpenConnection): void {
    const { peer } = connection;
    if (!peer.isLocal) this.#known.add(peer.address);
    this.#become(connection, 'live');
  }

  /** It is closed. For `OpenConnection`. */
  handleClose(connection: OpenConnection): void {
    if (!this.#open.delete(connection)) return;
    this.#silent.delete(connection);
    this.#leave(connection);
  }

  #become(connection: OpenConnection, kind: ConnectionKind): void {
    if (!this.#open.has(connection)) return;
    this.#leave(connection);
    connection.kind = kind;
    this.#enter(connection);
  }

  #hasRoom(connection: OpenConnection): boolean {
    for (const { limit, used, max, findVictim } of this.#levels(connection)) {
      if (used < max) continue;
      this.#limitWatch.count(limit);
      const victim = findVictim();
      if (victim === undefined) return false;
      victim.end();
    }
    return true;
  }

  /** From the narrowest limit to the widest: room that is made in one is room in the next. */
  *#levels(connection: OpenConnection): Iterable<Level> {
    const { peer, kind } = connection;
    const limits = this.#limits;
    const anyStranger = (): OpenConnection | undefined => this.#stranger(connection);
    if (kind !== 'local') {
      yield {
        limit: 'connectionsPerAddress',
        used: this.#groups.get(peer.address)?.open.size ?? 0,
        max: limits.connectionsPerAddress,
        findVictim: () => this.#oldestOf(peer.address),
      };
      yield {
        limit: 'connectionsPerNetwork',
        used: this.#byNetwork.get(peer.network) ?? 0,
        max: limits.connectionsPerNetwork,
        findVictim: () => this.#stranger(connection, peer.network),
      };
    }
    if (kind === 'stranger') {
      yield {
        limit: 'connectionsOfStrangers',
        used: this.#strangers,
        max: limits.connectionsOfStrangers,
        findVictim: anyStranger,
      };
    }
    if (kind !== 'local') {
      const kept = Math.floor(limits.connections / KEPT_FOR_THIS_MACHINE);
      const max = limits.connections - kept;
      yield { limit: 'connections', used: this.#remote, max, findVictim: anyStranger };
    }
    const used = this.#open.size;
    yield { limit: 'connections', used, max: limits.connections, findVictim: anyStranger };
  }

  /** The oldest connection of an address of which nothing is known, if it had time to say something. */
  #oldestOf(address: string): OpenConnection | undefined {
    for (const connection of this.#groups.get(address)?.open ?? []) {
      if (connection.kind === 'member') continue;
      return this.#isYoung(connection) ? undefined : connection;
    }
    return undefined;
  }

  /**
   * The stranger that is closed for a new connection: one of the address with most of them, when its own
   * has fewer, else the oldest that had time to say something. [AC-61]
   *
   * @param network looks among its addresses only
   */
  #stranger(newcomer: OpenConnection, network?: string): OpenConnection | undefined {
    let most: AddressGroup | undefined;
    let oldest: OpenConnection | undefined;
    for (const group of this.#groups.values()) {
      if (group.strangers === 0 || (network !== undefined && group.network !== network)) continue;
      if (group.strangers > (most?.strangers ?? 0)) most = group;
      const first = firstStranger(group);
      if (first !== undefined && first.openedMs < (oldest?.openedMs ?? Infinity)) oldest = first;
    }
    if (most === undefined || oldest === undefined) return undefined;
    const own = this.#groups.get(newcomer.peer.address)?.strangers ?? 0;
    if (newcomer.kind !== 'stranger' || most.strangers > own + 1) return firstStranger(most);
    return this.#isYoung(oldest) ? undefined : oldest;
  }

  #isYoung({ openedMs }: OpenConnection): boolean {
    return this.#clock.monotonicMs() - openedMs < GRACE_MS;
  }

  /** Closes connections without a request for too long. [AC-63] */
  #sweep(): void {
    const endMs = this.#clock.monotonicMs() - this.#limits.headersTimeoutMs;
    for (const connection of this.#silent) {
      if (connection.openedMs > endMs) return;
      connection.end();
    }
  }

  #enter(connection: OpenConnection): void {
    const { kind, peer } = connection;
    if (kind === 'local') return;
    if (!peer.isLocal) this.#remote++;
    if (kind === 'live') return;
    let group = this.#groups.get(peer.address);
    if (group === undefined) {
      group = { address: peer.address, network: peer.network, open: new Set(), strangers: 0 };
      this.#groups.set(peer.address, group);
    }
    group.open.add(connection);
    this.#byNetwork.set(peer.network, (this.#byNetwork.get(peer.network) ?? 0) + 1);
    if (kind !== 'stranger') return;
    group.strangers++;
    this.#strangers++;
  }

  #leave(connection: OpenConnection): void {
    const { kind, peer } = connection;
    if (kind === 'local') return;
    if (!peer.isLocal) this.#remote--;
    const group = this.#groups.get(peer.address);
    if (kind === 'live' || group === undefined) return;
    group.open.delete(connection);
    if (group.open.size === 0) this.#groups.delete(peer.address);
    const left = (this.#byNetwork.get(peer.network) ?? 1) - 1;
    if (left > 0) this.#byNetwork.set(peer.network, left);
    else this.#byNetwork.delete(peer.network);
    if (kind !== 'stranger') return;
    group.strangers--;
    this.#strangers--;
  }
}

function firstStranger({ open }: AddressGroup): OpenConnection | undefined {
  for (const connection of open) if (connection.kind === 'stranger') return connection;
  return undefined;
}
