import {
  encode,
  fromJson,
  type MessageType,
  type ProcessingModule,
  type Session,
} from '@ubii/proto';
import type { DocumentStore, StoredDocument } from '../ports/document-store.ts';

/** The messages that are stored. */
interface StoredTypes {
  'ubii.sessions.Session': Session;
  'ubii.processing.ProcessingModule': ProcessingModule;
}

/** A document that cannot be used, and why [SE-23]. */
export interface BrokenDocument {
  readonly key: string;
  readonly where: string;
  readonly reason: string;
}

interface Read<M> {
  readonly document: StoredDocument;
  readonly message: M | undefined;
  readonly reason: string;
  /** Encoded bytes of the message. */
  readonly byteLength: number;
}

/** The documents of a store as messages, found by the name inside [SE-20]. */
export class StoredMessages<T extends keyof StoredTypes & MessageType> {
  readonly store: DocumentStore;
  readonly #type: T;
  /** Cache of decoded documents, valid while the document is unchanged. */
  #read = new Map<string, Read<StoredTypes[T]>>();
  /** The documents that `#read` was made of. */
  #documents: ReadonlyMap<string, StoredDocument> | undefined = undefined;

  constructor(store: DocumentStore, type: T) {
    this.store = store;
    this.#type = type;
  }

  /** Every message that can be read. */
  entries(): { key: string; message: StoredTypes[T] }[] {
    return [...this.#refresh()].flatMap(([key, { message }]) =>
      message === undefined ? [] : [{ key, message }],
    );
  }

  /** The same by name; of two with one name the first. */
  list(): Map<string, { key: string; message: StoredTypes[T] }> {
    const messages = new Map<string, { key: string; message: StoredTypes[T] }>();
    for (const entry of this.entries()) {
      if (!messages.has(entry.message.name)) messages.set(entry.message.name, entry);
    }
    return messages;
  }

  get(name: string): StoredTypes[T] | undefined {
    for (const { message } of this.#refresh().values()) {
      if (message?.name === name) return message;
    }
    return undefined;
  }

  /** Encoded bytes of all messages. */
  get byteLength(): number {
    let sum = 0;
    for (const { byteLength } of this.#refresh().values()) sum += byteLength;
    return sum;
  }

  /** Encoded bytes of all messages but the one of this name. */
  bytesBeside(name: string): number {
    let sum = 0;
    for (const { message, byteLength } of this.#refresh().values()) {
      if (message?.name !== name) sum += byteLength;
    }
    return sum;
  }

  broken(): BrokenDocument[] {
    return [...this.#refresh()]
      .filter(([, { message }]) => message === undefined)
      .map(([key, { reason }]) => ({ key, where: this.store.describe(key), reason }));
  }

  /** Returns the storage key of the message with this name, existing or not. */
  keyOf(name: string): string {
    return this.list().get(name)?.key ?? name;
  }

  #refresh(): Map<string, Read<StoredTypes[T]>> {
    const documents = this.store.documents();
    if (documents === this.#documents) return this.#read;
    this.#documents = documents;
    const read = new Map<string, Read<StoredTypes[T]>>();
    for (const [key, document] of documents) {
      const before = this.#read.get(key);
      read.set(key, before?.document === document ? before : this.#decode(key, document));
    }
    return (this.#read = read);
  }

  #decode(key: string, document: StoredDocument): Read<StoredTypes[T]> {
    if (document.fault !== undefined) {
      return { document, message: undefined, reason: document.fault, byteLength: 0 };
    }
    try {
      const message = fromJson<keyof StoredTypes>(this.#type, document.json) as StoredTypes[T];
      const { byteLength } = encode<keyof StoredTypes>(this.#type, message);
      return {
        document,
        message: { ...message, name: message.name || key },
        reason: '',
        byteLength,
      };
    } catch (error) {
      const reason = error instanceof Error ? error.message : String(error);
      return { document, message: undefined, reason, byteLength: 0 };
    }
  }
}
