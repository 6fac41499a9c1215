import { promisify } from 'node:util';
import { gunzipSync, gzip } from 'node:zlib';
import type { JsonObject } from '@ubii/proto';
import type { Cancel } from '@ubii/timing';
import type { StoredDocument, DocumentStore } from '../../core/ports/index.ts';
import { decodeKey, encodeKey } from './key-names.ts';
import { KvTable } from './kv-table.ts';
import type { NatsLink } from './nats-link.ts';

const compress = promisify(gzip);

/** From this size on documents are compressed, bytes: NATS takes 1 MiB by default, and code shrinks to a fifth. */
const COMPRESSED_FROM = 32 * 1024;
/** Largest document that is read, bytes, as for files. */
const MAX_BYTES = 32 * 1024 * 1024;

/** The bytes of a document: JSON, with gzip when it is large. [CU-54] */
async function documentBytes(json: JsonObject): Promise<Uint8Array> {
  const text = Buffer.from(JSON.stringify(json));
  return text.byteLength < COMPRESSED_FROM ? text : compress(text);
}

/** Reads what another master or program wrote, which may be anything. */
export function readDocument(bytes: Uint8Array): StoredDocument {
  try {
    const isGzip = bytes[0] === 0x1f && bytes[1] === 0x8b;
    const text = isGzip ? gunzipSync(bytes, { maxOutputLength: MAX_BYTES }) : Buffer.from(bytes);
    return { json: JSON.parse(text.toString('utf8')) as unknown };
  } catch (error) {
    return { fault: error instanceof Error ? error.message : String(error) };
  }
}

/** Documents of a cluster, which every master reads and writes: a bucket of NATS, one key a document. [CU-54] */
export class NatsDocuments implements DocumentStore {
  readonly #table: KvTable;
  readonly #parsed = new Map<string, StoredDocument>();
  #documents: ReadonlyMap<string, StoredDocument> | undefined;
  readonly #listeners = new Set<(keys: readonly string[]) => void>();
  /** Writes follow one another: large ones take longer to compress, and the last one must win. */
  #queue: Promise<void> = Promise.resolve();

  private constructor(table: KvTable) {
    this.#table = table;
    for (const [rawKey] of table.values()) this.#read(rawKey);
    table.onChange((rawKey, isOwn) => this.#handleChange(rawKey, isOwn));
  }

  /** @throws ConfigError that says what to do when NATS has no such bucket to give */
  static async open(link: NatsLink, bucket: string): Promise<NatsDocuments> {
    return new NatsDocuments(await KvTable.open(link, bucket));
  }

  documents(): ReadonlyMap<string, StoredDocument> {
    this.#documents ??= new Map([...this.#parsed].sort(([a], [b]) => (a < b ? -1 : 1)));
    return this.#documents;
  }

  describe(key: string): string {
    return `${this.#table.name}/${key} in NATS`;
  }

  write(key: string, json: JsonObject): Promise<void> {
    return this.#enqueue(async () => {
      await this.#table.write(encodeKey(key), await documentBytes(json));
    });
  }

  delete(key: string): Promise<void> {
    return this.#enqueue(async () => {
      const rawKey = encodeKey(key);
      if (this.#parsed.has(key)) await this.#table.write(rawKey, undefined);
    });
  }

  onChange(fn: (keys: readonly string[]) => void): Cancel {
    this.#listeners.add(fn);
    return () => this.#listeners.delete(fn);
  }

  close(): void {
    this.#table.close();
    this.#listeners.clear();
  }

  /** Resolves when the queue is empty. */
  async settled(): Promise<void> {
    await this.#queue;
  }

  #enqueue(work: () => Promise<void>): Promise<void> {
    const done = this.#queue.then(work);
    this.#queue = done.catch(() => undefined);
    return done;
  }

  #handleChange(rawKey: string, isOwn: boolean): void {
    const key = this.#read(rawKey);
    if (key === undefined || isOwn) return;
    for (const listener of [...this.#listeners]) listener([key]);
  }

  /** Takes what the table has. @returns the key; undefined for one that no master writes */
  #read(rawKey: string): string | undefined {
    const key = decodeKey(rawKey);
    if (key === undefined) return undefined;
    const value = this.#table.get(rawKey)?.value;
    if (value === undefined) this.#parsed.delete(key);
    else this.#parsed.set(key, readDocument(value));
    this.#documents = undefined;
    return key;
  }
}
