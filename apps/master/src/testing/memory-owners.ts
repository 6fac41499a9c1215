import type { Cancel } from '@ubii/timing';

import type { OwnerStore } from '../core/ports/owner-store.ts';

/** Which master owns what, in memory: what all masters of a test see. */
export class MemoryOwnerTable {
  readonly #owners = new Map<string, string>();
  readonly #stores = new Set<MemoryOwners>();

  /** A store for one more master. */
  open(): MemoryOwners {
    const store: MemoryOwners = new MemoryOwners({
      owners: this.#owners,
      set: (key, owner) => this.#set(key, owner),
      leave: () => this.#stores.delete(store),
    });
    this.#stores.add(store);
    return store;
  }

  #set(key: string, owner: string | undefined): void {
    if (owner === undefined) this.#owners.delete(key);
    else this.#owners.set(key, owner);
    for (const store of this.#stores) store.handleChange();
  }
}

/** What a store asks of its table. */
interface TableSide {
  readonly owners: ReadonlyMap<string, string>;
  set(key: string, owner: string | undefined): void;
  leave(): void;
}

/** One master's side of a table. It learns of changes at the end of a turn, and of none while it cannot be reached. */
export class MemoryOwners implements OwnerStore {
  readonly #table: TableSide;
  readonly #listeners = new Set<(keys: readonly string[]) => void>();
  #known: ReadonlyMap<string, string>;
  #isReachable = true;

  constructor(table: TableSide) {
    this.#table = table;
    this.#known = new Map(table.owners);
  }

  owners(): ReadonlyMap<string, string> {
    return this.#known;
  }

  async claim(key: string, owner: string, from: string | undefined): Promise<boolean> {
    await this.#reach();
    const current = this.#table.owners.get(key);
    if (current === owner) return true;
    if (current !== from) return false;
    this.#table.set(key, owner);
    this.#learn();
    return true;
  }

  async release(key: string, owner: string): Promise<void> {
    await this.#reach();
    if (this.#table.owners.get(key) !== owner) return;
    this.#table.set(key, undefined);
    this.#learn();
  }

  onChange(fn: (keys: readonly string[]) => void): Cancel {
    this.#listeners.add(fn);
    return () => this.#listeners.delete(fn);
  }

  close(): void {
    this.#listeners.clear();
    this.#table.leave();
  }

  /** Takes the table away from this master, or gives it back with all that changed. */
  setReachable(isReachable: boolean): void {
    this.#isReachable = isReachable;
    if (isReachable) this.#learn();
  }

  /** Of the table: something changed. */
  handleChange(): void {
    queueMicrotask(() => this.#learn());
  }

  async #reach(): Promise<void> {
    await Promise.resolve();
    if (!this.#isReachable) throw new Error('The owners cannot be reached.');
  }

  /** Takes what the table has, and tells what is new. */
  #learn(): void {
    if (!this.#isReachable) return;
    const before = this.#known;
    const now = new Map(this.#table.owners);
    const changed = [...new Set([...before.keys(), ...now.keys()])].filter(
      (key) => before.get(key) !== now.get(key),
    );
    if (changed.length === 0) return;
    this.#known = now;
    for (const listener of [...this.#listeners]) listener(changed);
  }
}
