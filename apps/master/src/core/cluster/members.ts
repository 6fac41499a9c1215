import { encode, type ClusterHello, type ClusterMessage, type Init } from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import { Hook } from '../hooks/hook.ts';
import type { ClusterBus } from '../ports/cluster-bus.ts';

/** Interval at which a master says that it is there, milliseconds. [CU-2] */
export const HELLO_MS = 500;
/** Silence after which a master counts as lost, milliseconds. [CU-3] */
export const LOST_MS = 2_500;
/** Version of the messages of a cluster. */
export const CLUSTER_VERSION = 1;

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
  /** Since when it is there, epoch milliseconds. */
  readonly sinceMs: number;
}

/** What a master says of itself. */
export type OwnMember = Omit<Member, 'id' | 'sinceMs'>;

/** Dependencies of members. */
export interface MembersContext {
  readonly clock: Clock;
  readonly bus: ClusterBus;
  readonly self: () => OwnMember;
}

interface Heard {
  member: Member;
  heardMs: number;
}

/** Other masters of the cluster, as long as they are heard. */
export class Members {
  /** A master is there that was not, or says something else of itself. */
  readonly onJoined = new Hook<[member: Member]>();
  /** A master said that it ends, or is not heard any more. */
  readonly onLost = new Hook<[member: Member, hasEnded: boolean]>();
  readonly #context: MembersContext;
  readonly #members = new Map<string, Heard>();

  constructor(context: MembersContext) {
    this.#context = context;
  }

  /** Sorted by name, then by id. */
  list(): Member[] {
    return [...this.#members.values()]
      .map(({ member }) => member)
      .sort((a, b) => a.name.localeCompare(b.name) || (a.id < b.id ? -1 : 1));
  }

  get(id: string): Member | undefined {
    return this.#members.get(id)?.member;
  }

  /** Says to all that this master is there. */
  sayHello(): void {
    const { name, addresses, version: masterVersion, startedMs } = this.#context.self();
    const said = { name, addresses: [...addresses], masterVersion, startedMs };
    this.#broadcast({ hello: { ...said, version: CLUSTER_VERSION } });
  }

  /** Says to all that it ends. */
  sayGoodbye(): void {
    this.#broadcast({ goodbye: {} });
  }

  handleHello(id: string, hello: ClusterHello): void {
    if (hello.version !== CLUSTER_VERSION) return;
    const before = this.#members.get(id);
    const { clock } = this.#context;
    const { name, addresses, masterVersion: version, startedMs } = hello;
    const sinceMs = before?.member.sinceMs ?? clock.nowMs();
    const member = { id, name, addresses, version, startedMs, sinceMs };
    this.#members.set(id, { member, heardMs: clock.monotonicMs() });
    if (before === undefined || !isSame(before.member, member)) this.onJoined.emit(member);
  }

  /** A master sent something. */
  handleSign(id: string): void {
    const heard = this.#members.get(id);
    if (heard !== undefined) heard.heardMs = this.#context.clock.monotonicMs();
  }

  handleGoodbye(id: string): void {
    this.#lose(id, true);
  }

  /** Gives up masters that are silent. */
  sweep(): void {
    const nowMs = this.#context.clock.monotonicMs();
    for (const [id, { heardMs }] of this.#members) {
      if (nowMs - heardMs >= LOST_MS) this.#lose(id, false);
    }
  }

  #lose(id: string, hasEnded: boolean): void {
    const heard = this.#members.get(id);
    if (heard === undefined || !this.#members.delete(id)) return;
    this.onLost.emit(heard.member, hasEnded);
  }

  #broadcast(message: Init<ClusterMessage>): void {
    this.#context.bus.broadcast(encode('ubii.extension.ClusterMessage', message));
  }
}

function isSame(a: Member, b: Member): boolean {
  return a.name === b.name && a.addresses.join() === b.addresses.join();
}
