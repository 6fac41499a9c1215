import { readRecordHead } from '@ubii/proto/wire';
import type { Clock } from '@ubii/timing';
import type { Limits } from '../limits/index.ts';
import type { Accounts, Share } from '../shares/accounts.ts';
import { fillMaxOf, type Shortage } from '../shares/shortage.ts';
import type { TopicEntry, TopicOwner } from './topic-entry.ts';
import type { TopicTable } from './topic-table.ts';

/** Dependencies of kept values. */
export interface KeptValuesContext {
  readonly clock: Clock;
  readonly limits: Limits;
  readonly topics: TopicTable;
  readonly accounts: Accounts;
}

/** Owns the kept values of a client that left, and pays for them out of the share it had. */
interface AbsentOwner extends TopicOwner {
  readonly invitationId: string | undefined;
}

/** Values that outlive their publisher, because its newest record asked for it [TD-43]. */
export class KeptValues {
  readonly #context: KeptValuesContext;
  readonly #owners = new Map<string, AbsentOwner>();
  /** End of each kept value, monotonic milliseconds. */
  readonly #endMs = new Map<TopicEntry, number>();

  constructor(context: KeptValuesContext) {
    this.#context = context;
  }

  /** Ends the values of a client that left or was lost, at once or when their time is over [TD-40] [TD-43]. */
  handleAbsent(owner: TopicOwner, share: Share): void {
    const nowMs = this.#context.clock.monotonicMs();
    for (const entry of [...owner.ownedTopics]) {
      const keepMs = this.#keepMsOf(entry);
      if (keepMs > 0) this.#keep(entry, this.#absentOwner(owner.id, share), nowMs + keepMs);
      else this.#context.topics.deleteValue(entry);
    }
  }

  /** Gives a client that came back the values that were kept for it [TD-45]. */
  handleReturn(client: TopicOwner): void {
    const owner = this.#owners.get(client.id);
    if (owner === undefined) return;
    for (const entry of [...owner.ownedTopics]) {
      this.#endMs.delete(entry);
      this.#context.topics.transfer(entry, client);
      entry.isKept = false;
    }
    this.#forget(owner);
  }

  /** Another client publishes on the topic of a kept value, and owns it from now on [TD-19]. */
  handleAdopted(entry: TopicEntry, client: TopicOwner): void {
    const owner = this.#owners.get(entry.owner?.id ?? '');
    this.#endMs.delete(entry);
    this.#context.topics.transfer(entry, client);
    entry.isKept = false;
    if (owner !== undefined) this.#forgetIfEmpty(owner);
  }

  /** Replaces the value by a newer one of another master, which has no owner here. [CU-12] */
  handleReplaced(entry: TopicEntry): void {
    const owner = this.#owners.get(entry.owner?.id ?? '');
    this.#endMs.delete(entry);
    entry.isKept = false;
    if (entry.owner !== undefined) this.#context.topics.disown(entry);
    if (owner !== undefined) this.#forgetIfEmpty(owner);
  }

  /** Deletes the kept values of a client [TD-46]. */
  deleteOf(clientId: string): void {
    const owner = this.#owners.get(clientId);
    for (const entry of [...(owner?.ownedTopics ?? [])]) this.#delete(entry);
  }

  /** Deletes the kept values of all clients of an invitation [TD-46]. */
  deleteOfInvitation(invitationId: string): void {
    for (const { id, invitationId: of } of [...this.#owners.values()]) {
      if (of === invitationId) this.deleteOf(id);
    }
  }

  /** Deletes the values whose time is over. */
  sweep(): void {
    const nowMs = this.#context.clock.monotonicMs();
    for (const [entry, endMs] of this.#endMs) if (nowMs >= endMs) this.#delete(entry);
  }

  /**
   * Deletes kept values until there is room, those first that are kept longest; never those of a class that may
   * use more than the account that asks [TD-44] [AC-84].
   */
  makeRoom({ account: asking, resource, level }: Shortage, hasRoom: () => boolean): void {
    const fillMax = fillMaxOf(asking, resource);
    for (const entry of this.#endMs.keys()) {
      const account = entry.owner?.account;
      if (account?.isWithin(level) !== true || fillMaxOf(account, resource) > fillMax) continue;
      this.#delete(entry);
      if (hasRoom()) return;
    }
  }

  #keepMsOf({ record }: TopicEntry): number {
    if (record === undefined) return 0;
    const { keepSeconds: seconds, expiryMs } = readRecordHead(record);
    if (expiryMs > 0) return 0; // [TD-47]
    return Math.max(0, Math.min(seconds * 1000, this.#context.limits.keepMs));
  }

  #absentOwner(id: string, share: Share): AbsentOwner {
    let owner = this.#owners.get(id);
    if (owner === undefined) {
      const account = this.#context.accounts.createClient(id, share);
      owner = { id, account, ownedTopics: new Set(), invitationId: share.invitation?.id };
      this.#owners.set(id, owner);
    }
    return owner;
  }

  #keep(entry: TopicEntry, owner: AbsentOwner, endMs: number): void {
    this.#context.topics.transfer(entry, owner);
    entry.isKept = true;
    this.#endMs.set(entry, endMs);
  }

  #delete(entry: TopicEntry): void {
    const owner = this.#owners.get(entry.owner?.id ?? '');
    this.#endMs.delete(entry);
    entry.isKept = false;
    this.#context.topics.deleteValue(entry);
    if (owner !== undefined) this.#forgetIfEmpty(owner);
  }

  #forgetIfEmpty(owner: AbsentOwner): void {
    if (owner.ownedTopics.size === 0) this.#forget(owner);
  }

  #forget(owner: AbsentOwner): void {
    this.#owners.delete(owner.id);
    this.#context.accounts.close(owner.account);
  }
}
