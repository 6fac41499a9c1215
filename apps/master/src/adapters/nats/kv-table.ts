import type { Cancel, Clock } from '@ubii/timing';
import { KvBucket, type KvEntry } from './kv-bucket.ts';
import { BucketFollower } from './bucket-follower.ts';
import { explainStores } from './explain-nats-error.ts';
import type { WatchedEntry } from './kv-watch.ts';
import type { NatsLink } from './nats-link.ts';

/** By then every master has received a removal, milliseconds. */
const KEPT_MS = 10 * 60_000;
/** How often it is checked, milliseconds. */
const CHECK_MS = 60_000;
/** At most this many keys are forgotten at once. */
const MAX_AT_ONCE = 100;

interface Removal {
  readonly rawKey: string;
  readonly revision: number;
  readonly timeMs: number;
}

/**
 * What is left of deleted keys in a bucket. It tells masters that were away of the removal, and is removed itself
 * later, or a bucket of sessions that come and go would grow forever. NATS does so by itself from version 2.11.
 */
export class Removals {
  readonly #bucket: Pick<KvBucket, 'forget'>;
  readonly #clock: Clock;
  readonly #handleForgotten: (rawKey: string, revision: number) => void;
  readonly #cancel: Cancel;
  #waiting: Removal[] = [];

  /** @param handleForgotten called when nothing is left of a deletion */
  constructor(
    bucket: Pick<KvBucket, 'forget'>,
    clock: Clock,
    handleForgotten: (rawKey: string, revision: number) => void,
  ) {
    this.#bucket = bucket;
    this.#clock = clock;
    this.#handleForgotten = handleForgotten;
    this.#cancel = clock.every(CHECK_MS, () => this.#forgetOld());
  }

  add(rawKey: string, revision: number, timeMs: number): void {
    this.#waiting.push({ rawKey, revision, timeMs });
  }

  close(): void {
    this.#cancel();
  }

  #forgetOld(): void {
    const until = this.#clock.nowMs() - KEPT_MS;
    const old = this.#waiting.filter(({ timeMs }) => timeMs < until).slice(0, MAX_AT_ONCE);
    if (old.length === 0) return;
    const isOld = new Set(old);
    this.#waiting = this.#waiting.filter((each) => !isOld.has(each));
    for (const removal of old) {
      const { rawKey, revision } = removal;
      this.#bucket.forget(rawKey, revision).then(
        () => this.#handleForgotten(rawKey, revision),
        () => this.#waiting.push(removal), // While NATS is away: later.
      );
    }
  }
}

/** Called with a key that changed. @param isOwn it was changed by this table */
type TableListener = (rawKey: string, isOwn: boolean) => void;

/** A bucket of NATS as a table that is always at hand: what others change comes by itself. [CU-53] */
export class KvTable {
  readonly #link: NatsLink;
  readonly #bucket: KvBucket;
  readonly #follower: BucketFollower;
  readonly #removals: Removals;
  readonly #entries = new Map<string, KvEntry>();
  readonly #listeners = new Set<TableListener>();
  /** Own writes that NATS has not confirmed, by key, and what came of others meanwhile. */
  readonly #writing = new Map<string, { count: number; readonly held: WatchedEntry[] }>();
  /** While all values are told again: those that were not yet. */
  #untold = new Map<string, KvEntry>();
  /** Values that NATS lost and that are written back. */
  readonly #unstored = new Set<string>();

  private constructor(link: NatsLink, name: string) {
    this.#link = link;
    this.#bucket = new KvBucket(link, name);
    this.#follower = new BucketFollower(link, this.#bucket, {
      handleBegin: (isAnew) => this.#handleBegin(isAnew),
      handleEntry: (entry) => this.#handleEntry(entry),
      handleComplete: () => this.#handleComplete(),
    });
    this.#removals = new Removals(this.#bucket, link.clock, (rawKey, revision) => {
      if (this.#entries.get(rawKey)?.revision === revision) this.#entries.delete(rawKey);
    });
  }

  /** Opens the bucket, creates it if it is missing, and reads all of it. @throws ConfigError that says what to do */
  static async open(link: NatsLink, name: string): Promise<KvTable> {
    const table = new KvTable(link, name);
    try {
      await table.#follower.start();
      return table;
    } catch (error) {
      table.close();
      throw explainStores(error);
    }
  }

  get name(): string {
    return this.#bucket.name;
  }

  /** The keys that have a value, with their value. */
  *values(): Iterable<readonly [rawKey: string, value: Uint8Array]> {
    for (const [rawKey, { value }] of this.#entries) if (value) yield [rawKey, value];
  }

  /** What is known of a key; without a value when it was deleted. */
  get(rawKey: string): KvEntry | undefined {
    return this.#entries.get(rawKey);
  }

  /** Reads a key from NATS. */
  read(rawKey: string): Promise<KvEntry | undefined> {
    return this.#bucket.read(rawKey);
  }

  /**
   * Writes a key, or deletes it, as `KvBucket.write`. It is in the table when the promise is fulfilled.
   *
   * @returns false when the key has another revision
   */
  async write(rawKey: string, value: Uint8Array | undefined, expected?: number): Promise<boolean> {
    const writing = this.#writing.get(rawKey) ?? { count: 0, held: [] };
    this.#writing.set(rawKey, writing);
    writing.count += 1;
    try {
      const revision = await this.#bucket.write(rawKey, value, expected);
      if (revision === undefined) return false;
      this.#apply({ rawKey, revision, value, timeMs: this.#link.clock.nowMs() }, true);
      return true;
    } finally {
      writing.count -= 1;
      if (writing.count === 0) {
        this.#writing.delete(rawKey);
        for (const entry of writing.held) this.#apply(entry, false);
      }
    }
  }

  onChange(fn: TableListener): Cancel {
    this.#listeners.add(fn);
    return () => this.#listeners.delete(fn);
  }

  close(): void {
    this.#follower.close();
    this.#removals.close();
    this.#listeners.clear();
  }

  #handleBegin(isAnew: boolean): void {
    // Revisions of the bucket before say nothing about those of a new one.
    if (isAnew) {
      for (const [rawKey, { value }] of this.#entries) {
        this.#entries.set(rawKey, { revision: 0, value });
        this.#unstored.add(rawKey);
      }
    }
    this.#untold = new Map(this.#entries);
  }

  /**
   * What was in the table before, and was not told again, is not in the bucket any more: it was deleted, or NATS lost
   * its storage. Then it is written back.
   */
  #handleComplete(): void {
    const lost: string[] = [];
    for (const [rawKey, entry] of this.#untold) {
      // Written here meanwhile: it is told later.
      if (this.#entries.get(rawKey) !== entry) continue;
      if (this.#unstored.has(rawKey)) {
        lost.push(rawKey);
        continue;
      }
      this.#entries.delete(rawKey);
      if (entry.value !== undefined) this.#emit(rawKey, false);
    }
    this.#untold.clear();
    if (lost.length > 0) void this.#writeBack(lost);
  }

  async #writeBack(rawKeys: readonly string[]): Promise<void> {
    const { log } = this.#link;
    log.warn('NATS lost what it had stored; writing it back', {
      store: this.name,
      count: rawKeys.length,
    });
    for (const rawKey of rawKeys) {
      const entry = this.#entries.get(rawKey);
      // Another master was faster, or it was written meanwhile.
      if (entry?.revision !== 0) continue;
      try {
        // Deletions as well: a master that comes back later must not bring the value with it.
        await this.write(rawKey, entry.value, 0);
      } catch (error) {
        log.warn('a document could not be written back', { reason: String(error) });
        // The rest is tried when NATS is back.
        return;
      }
    }
  }

  #handleEntry(entry: WatchedEntry): void {
    this.#untold.delete(entry.rawKey);
    const writing = this.#writing.get(entry.rawKey);
    if (writing === undefined) this.#apply(entry, false);
    else writing.held.push(entry);
  }

  #apply({ rawKey, revision, value, timeMs }: WatchedEntry, isOwn: boolean): void {
    const known = this.#entries.get(rawKey);
    if (known !== undefined && known.revision >= revision) return;
    this.#entries.set(rawKey, { revision, value });
    this.#unstored.delete(rawKey);
    if (value === undefined) this.#removals.add(rawKey, revision, timeMs);
    if (known?.value === undefined && value === undefined) return;
    // Written back by another master.
    if (known?.revision === 0 && isEqual(known.value, value)) return;
    this.#emit(rawKey, isOwn);
  }

  #emit(rawKey: string, isOwn: boolean): void {
    for (const listener of [...this.#listeners]) listener(rawKey, isOwn);
  }
}

function isEqual(a: Uint8Array | undefined, b: Uint8Array | undefined): boolean {
  return a !== undefined && b !== undefined && Buffer.compare(a, b) === 0;
}
