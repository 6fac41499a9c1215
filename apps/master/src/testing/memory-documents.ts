import type { JsonObject } from '@ubii/proto';
import type { Cancel } from '@ubii/timing';
import type {
  DocumentStore,
  SessionStorage,
  StoredDocument,
  StudyStorage,
} from '../core/ports/document-store.ts';

/** Documents in memory, which a test may change as people do with files. */
export class MemoryDocuments implements DocumentStore {
  #documents: ReadonlyMap<string, StoredDocument> = new Map();
  readonly #listeners = new Set<(keys: readonly string[]) => void>();

  documents(): ReadonlyMap<string, StoredDocument> {
    return this.#documents;
  }

  describe(key: string): string {
    return `memory of ${key}`;
  }

  write(key: string, json: JsonObject): Promise<void> {
    this.#set(key, { json: JSON.parse(JSON.stringify(json)) });
    return Promise.resolve();
  }

  delete(key: string): Promise<void> {
    this.#set(key, undefined);
    return Promise.resolve();
  }

  onChange(fn: (keys: readonly string[]) => void): Cancel {
    this.#listeners.add(fn);
    return () => this.#listeners.delete(fn);
  }

  close(): void {
    this.#listeners.clear();
  }

  /** Edits the document as a person would edit its file; undefined removes it. */
  edit(key: string, text: string | undefined): void {
    this.#set(key, text === undefined ? undefined : parse(text));
    for (const listener of this.#listeners) listener([key]);
  }

  #set(key: string, document: StoredDocument | undefined): void {
    const documents = new Map(this.#documents);
    if (document === undefined) documents.delete(key);
    else documents.set(key, document);
    this.#documents = documents;
  }
}

/** Storage in memory. Handed to a second master, it is what a data directory is to a second run. */
export class MemoryStorage implements SessionStorage {
  readonly sessions = new MemoryDocuments();
  readonly modules = new MemoryDocuments();
  readonly running = new MemoryDocuments();
  readonly history = new MemoryDocuments();
}

/** Studies in memory. */
export class MemoryStudyStorage implements StudyStorage {
  readonly studies = new MemoryDocuments();
  readonly runs = new MemoryDocuments();
}

function parse(text: string): StoredDocument {
  try {
    return { json: JSON.parse(text) };
  } catch (error) {
    return { fault: `it is not valid JSON: ${String(error)}` };
  }
}
