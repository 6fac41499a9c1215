import type { Cancel } from '@ubii/timing';

import type { OwnerStore } from '../../core/ports/index.ts';
import { decodeKey, encodeKey } from './key-names.ts';
import type { KvEntry } from './kv-bucket.ts';
import { KvTable } from './kv-table.ts';
import type { NatsLink } from './nats-link.ts';

/** Owners of a cluster in a bucket of NATS. Revisions decide which of several masters was the first. [CU-55] */
export class NatsOwners implements OwnerStore {
  readonly #table: KvTable;
  readonly #listeners = new Set<(keys: readonly string[]) => void>();
  #owners: ReadonlyMap<string, string> | undefined;

  private constructor(table: KvTable) {
    this.#table = table;
    table.onChange((rawKey) => this.#handleChange(rawKey));
  }

  /** @throws ConfigError that says what to do when NATS has no such bucket to give */
  static async open(link: NatsLink, bucket: string): Promise<NatsOwners> {
    return new NatsOwners(await KvTable.open(link, bucket));
  }

  owners(): ReadonlyMap<string, string> {
    this.#owners ??= this.#read();
    return this.#owners;
  }

  claim(key: string, owner: string, from: string | undefined): Promise<boolean> {
    return this.#change(encodeKey(key), (current) => {
      // A claim whose answer was lost has reached its aim.
      if (current === owner) return 'done';
      return current === from ? Buffer.from(owner) : 'lost';
    });
  }

  async release(key: string, owner: string): Promise<void> {
    await this.#change(encodeKey(key), (current) => (current === owner ? undefined : 'lost'));
  }

  onChange(fn: (keys: readonly string[]) => void): Cancel {
    this.#listeners.add(fn);
    return () => this.#listeners.delete(fn);
  }

  close(): void {
    this.#table.close();
    this.#listeners.clear();
  }

  /**
   * Changes a key by what NATS has of it, and not by what is known here, which may be old.
   *
   * @param decide the new value, or that nothing is to be changed, because it is so already or may not be
   */
  async #change(
    rawKey: string,
    decide: (current: string | undefined) => Uint8Array | undefined | 'done' | 'lost',
  ): Promise<boolean> {
    for (;;) {
      const entry = await this.#table.read(rawKey);
      const value = decide(ownerOf(entry));
      if (value === 'done' || value === 'lost') return value === 'done';
      if (await this.#table.write(rawKey, value, entry?.revision ?? 0)) return true;
      // Another master changed it meanwhile, to an owner that decides.
    }
  }

  #read(): ReadonlyMap<string, string> {
    const owners = new Map<string, string>();
    for (const [rawKey, value] of this.#table.values()) {
      const key = decodeKey(rawKey);
      if (key !== undefined) owners.set(key, Buffer.from(value).toString('utf8'));
    }
    return owners;
  }

  #handleChange(rawKey: string): void {
    this.#owners = undefined;
    const key = decodeKey(rawKey);
    if (key === undefined) return;
    for (const listener of [...this.#listeners]) listener([key]);
  }
}

function ownerOf(entry: KvEntry | undefined): string | undefined {
  return entry?.value && Buffer.from(entry.value).toString('utf8');
}
