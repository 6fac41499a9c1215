import type { JsonObject } from '@ubii/proto';
import type { Cancel } from '../core/ports/clock.ts';
import type {
  DocumentStore,
  SessionStorage,
  StoredDocument,
} from '../core/ports/document-store.ts';

/** Documents in memory, which a test may change as people do with files. */
export class MemoryDocuments implements DocumentStore {
  readonly #documents = new Map<string, StoredDocument>();
  readonly #listeners = new Set<(keys: readonly string[]) => void>();

  documents(): ReadonlyMap<string, StoredDocument> {
    return this.#documents;
  }

  describe(key: string): string {
    return `memory of ${key}`;
  }

  write(key: string, json: JsonObject): Promise<void> {
    this.#documents.set(key, { json: JSON.parse(JSON.stringify(json)) });
    return Promise.resolve();
  }

  delete(key: string): Promise<void> {
    this.#documents.delete(key);
    return Promise.resolve();
  }

  onChange(fn: (keys: readonly string[]) => void): Cancel {
    this.#listeners.add(fn);
    return () => this.#listeners.delete(fn);
  }

  close(): void {
    this.#listeners.clear();
  }

  /** Somebody edits the document by hand; undefined removes it. */
  edit(key: string, text: string | undefined): void {
    if (text === undefined) this.#documents.delete(key);
    else this.#documents.set(key, parse(text));
    for (const listener of this.#listeners) listener([key]);
  }
}

/** Storage in memory. Handed to a second master, it is what a data directory is to a second run. */
export class MemoryStorage implements SessionStorage {
  readonly sessions = new MemoryDocuments();
  readonly modules = new MemoryDocuments();
  readonly running = new MemoryDocuments();
}

function parse(text: string): StoredDocument {
  try {
    return { json: JSON.parse(text) };
  } catch (error) {
    return { fault: `it is no JSON: ${String(error)}` };
  }
}
