import type { JsonObject } from '@ubii/proto';
import type { Cancel } from '@ubii/timing';

/** A document as it was read, or why it could not be. */
export type StoredDocument =
  | { readonly json: unknown; readonly fault?: undefined }
  | { readonly json?: undefined; readonly fault: string };

/** Named JSON documents of one kind, kept between runs. People may change them by hand at any time. */
export interface DocumentStore {
  /** Every document as it is now, by its key. Another map after each change, the same one until then. */
  documents(): ReadonlyMap<string, StoredDocument>;
  /** Returns the location of the document with this key, for messages. */
  describe(key: string): string;
  /**
   * Writes a document as a whole or not at all. It counts when the promise is fulfilled.
   * @param key Any text. Must be unique, unless `documents` says otherwise.
   */
  write(key: string, json: JsonObject): Promise<void>;
  /** Deletes a document. One that is not there is deleted already. */
  delete(key: string): Promise<void>;
  /** Calls `fn` with the keys of documents that others added, changed or removed. */
  onChange(fn: (keys: readonly string[]) => void): Cancel;
  /** Ends the watching. */
  close(): void;
}

/** The stored sessions and modules of a master [SE-20]. */
export interface SessionStorage {
  /** Stored sessions, by name. */
  readonly sessions: DocumentStore;
  /** Stored modules, by name. */
  readonly modules: DocumentStore;
  /** Sessions that are started again with the next master, by id [SE-24]. */
  readonly running: DocumentStore;
  /** Earlier versions of modules [EX-42]. */
  readonly history: DocumentStore;
}

/** The stored studies of a master, readable by the master alone [ST-1]. */
export interface StudyStorage {
  /** Studies, by id. */
  readonly studies: DocumentStore;
  /** Runs of studies, by id. */
  readonly runs: DocumentStore;
}
