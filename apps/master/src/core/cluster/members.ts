import type { ClusterHello } from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import { Hook } from '../hooks/hook.ts';
import type { ProvenBus } from './proven-bus.ts';

/** Interval at which a master says that it is there, milliseconds. [CU-2] */
export const HELLO_MS = 500;
/** Silence after which a master counts as lost, milliseconds. [CU-3] */
export const LOST_MS = 2_500;
/** Version of the messages of a cluster. */
export const CLUSTER_VERSION = 2;

/** Another master. */
export interface Member {
  readonly id: string;
  readonly name: string;
  /** Of its frontend, best first. */
  readonly addresses: readonly string[];
  /** Of its program, semantic versioning. */
  readonly version: string;
  /** By its own clock, epoch milliseconds. */
  readonly startedMs: number;
  /** Tells its installation apart from others of the cluster. [AC-43] */
  readonly installation: string;
  /** Since when it is there, epoch milliseconds. */
  readonly sinceMs: number;
}

/** What a master says of itself. */
export type OwnMember = Omit<Member, 'id' | 'sinceMs'>;

/** Dependencies of members. */
export interface MembersContext {
  readonly clock: Clock;
  readonly bus: Pick<ProvenBus, 'broadcast'>;
  readonly self: () => OwnMember;
}

interface Entry {
  member: Member;
  lastSeenMs: number;
}

/** The reachable other masters of the cluster. */
export class Members {
  /** A master is there that was not, or says something else of itself. */
  readonly onJoined = new Hook<[member: Member]>();
  /** A master announced its end, or is silent for too long. */
  readonly onLost = new Hook<[member: Member, hasEnded: boolean]>();
  readonly #context: MembersContext;
  readonly #members = new Map<string, Entry>();
  /** Those that fell silent, as long as they may be there and not be entry. */
  readonly #silent = new Map<string, Entry>();

  constructor(context: MembersContext) {
    this.#context = context;
  }

  /** Sorted by name, then by id. */
  list(): Member[] {
    return sorted(this.#members);
  }

  /**
   * Where clients can go: to those that are there. While none is entry, to those that fell silent, because it may be
   * this master that is cut off; never to those that said goodbye. [CU-26]
   */
  listForClients(): Member[] {
    return sorted(this.#members.size > 0 ? this.#members : this.#silent);
  }

  get(id: string): Member | undefined {
    return this.#members.get(id)?.member;
  }

  /** Says to all that this master is there. */
  sayHello(): void {
    const { addresses, version: masterVersion, ...others } = this.#context.self();
    const said = { ...others, addresses: [...addresses], masterVersion };
    this.#context.bus.broadcast({ hello: { ...said, version: CLUSTER_VERSION } });
  }

  /** Says to all that it ends. */
  sayGoodbye(): void {
    this.#context.bus.broadcast({ goodbye: {} });
  }

  handleHello(id: string, hello: ClusterHello): void {
    if (hello.version !== CLUSTER_VERSION) return;
    const before = this.#members.get(id);
    const { clock } = this.#context;
    const { name, addresses, masterVersion: version, startedMs, installation } = hello;
    const sinceMs = before?.member.sinceMs ?? clock.nowMs();
    const member = { id, name, addresses, version, startedMs, installation, sinceMs };
    this.#members.set(id, { member, lastSeenMs: clock.monotonicMs() });
    this.#silent.delete(id);
    if (before === undefined || !isSame(before.member, member)) this.onJoined.emit(member);
  }

  /** A master sent a message. @returns whether it has identified itself */
  handleSign(id: string): boolean {
    const entry = this.#members.get(id);
    if (entry !== undefined) entry.lastSeenMs = this.#context.clock.monotonicMs();
    return entry !== undefined;
  }

  handleGoodbye(id: string): void {
    this.#silent.delete(id);
    this.#lose(id, true);
  }

  /** Gives up masters that are silent. */
  sweep(): void {
    const nowMs = this.#context.clock.monotonicMs();
    for (const [id, entry] of this.#members) {
      if (nowMs - entry.lastSeenMs < LOST_MS) continue;
      this.#silent.set(id, entry);
      this.#lose(id, false);
    }
    // With another master reachable, these are down, and this one is not cut off.
    for (const [id, { lastSeenMs }] of this.#silent) {
      if (this.#members.size > 0 && nowMs - lastSeenMs >= 2 * LOST_MS) this.#silent.delete(id);
    }
  }

  #lose(id: string, hasEnded: boolean): void {
    const entry = this.#members.get(id);
    if (entry === undefined || !this.#members.delete(id)) return;
    this.onLost.emit(entry.member, hasEnded);
  }
}

function sorted(entries: ReadonlyMap<string, Entry>): Member[] {
  return [...entries.values()]
    .map(({ member }) => member)
    .sort((a, b) => a.name.localeCompare(b.name) || (a.id < b.id ? -1 : 1));
}

function isSame(a: Member, b: Member): boolean {
  return a.name === b.name && a.addresses.join() === b.addresses.join();
}
