import type { Protocol } from './mapping.ts';
import { readMappingFile, type MappingFile } from './read-mapping-file.ts';
import { findMappingProblems, type MappingProblem } from './find-mapping-problems.ts';

/** Mappings of a bridge without a file. */
const EMPTY_FILE = '{\n  "version": 1,\n  "mappings": []\n}\n';

/** A mapping file as it is written, and what it means. */
interface MappingDocument {
  readonly text: string;
  readonly file: MappingFile;
  /** Its mappings as they are written. */
  readonly written: readonly unknown[];
}

/** @throws MappingError when it is wrong */
export function readDocument(text: string, protocol: Protocol): MappingDocument {
  const file = readMappingFile(text, protocol);
  const { mappings } = JSON.parse(text) as { readonly mappings: readonly unknown[] };
  return { text, file, written: mappings };
}

/**
 * The file with other mappings. Its other members, their order and its indentation stay; each member of a mapping gets a line of
 * its own. [BR-83]
 */
function withMappings(text: string, mappings: readonly unknown[]): string {
  const json = JSON.parse(text) as object;
  return `${JSON.stringify({ ...json, mappings }, null, indentOf(text))}\n`;
}

/** That of the first line that has one; 2 spaces for a file on one line. */
function indentOf(text: string): string {
  const [, indent = '  '] = /\n([ \t]{1,8})\S/.exec(text) ?? [];
  return indent;
}

/** The place of a mapping file. */
export interface MappingStorage {
  readonly path: string;
  /** Returns its text; `undefined` when there is no file. @throws Error when it cannot be read */
  read(): string | undefined;
  /** Writes it as a whole or not at all. @throws Error when that fails */
  write(text: string): void;
}

/** Arguments of a `MappingStore`. */
interface MappingStoreContext {
  readonly protocol: Protocol;
  readonly storage: MappingStorage;
  /** A short text that is another one for another text. */
  digest(text: string): string;
}

/** What became of mappings that were to be saved. */
export type Saved =
  | { readonly outcome: 'saved' | 'conflict' }
  | { readonly outcome: 'refused'; readonly problems: readonly MappingProblem[] };

/** The mappings of a bridge and their file, which people and pages change. [BR-4] [BR-82] [BR-83] */
export class MappingStore {
  readonly protocol: Protocol;
  readonly #storage: MappingStorage;
  readonly #digest: (text: string) => string;
  /** What applies. */
  #document: MappingDocument;
  /** What stands in the file, also when it is wrong; `undefined`: there is none. */
  #text: string | undefined;
  #problem = '';

  /** @throws Error when the file cannot be read, or is wrong */
  constructor({ protocol, storage, digest }: MappingStoreContext) {
    this.protocol = protocol;
    this.#storage = storage;
    this.#digest = digest;
    this.#text = storage.read();
    this.#document = readDocument(this.#text ?? EMPTY_FILE, protocol);
  }

  get path(): string {
    return this.#storage.path;
  }

  /** What applies. */
  get file(): MappingFile {
    return this.#document.file;
  }

  /** The mappings that apply, as they are written. */
  get written(): readonly unknown[] {
    return this.#document.written;
  }

  /** Another one for each content of the file. */
  get revision(): string {
    return this.#digest(this.#text ?? '');
  }

  get fileExists(): boolean {
    return this.#text !== undefined;
  }

  /** Why the file does not apply as it is; empty when it does. */
  get fileProblem(): string {
    return this.#problem;
  }

  /** Reads the file again. One that is wrong or gone changes nothing that applies. [BR-4] */
  refresh(): void {
    try {
      this.#text = this.#storage.read();
      if (this.#text !== undefined && this.#text !== this.#document.text) {
        this.#document = readDocument(this.#text, this.protocol);
      }
      this.#problem = '';
    } catch (error) {
      this.#problem = (error as Error).message;
    }
  }

  /**
   * Replaces the mappings, in the file as well, if it is still the one of that revision. [BR-82]
   *
   * @throws Error when the file cannot be written: then nothing has changed
   */
  save(mappings: readonly unknown[], revision: string): Saved {
    this.refresh();
    if (revision !== this.revision || this.#problem !== '') return { outcome: 'conflict' };
    const { problems } = findMappingProblems(mappings, this.protocol);
    if (problems.length > 0) return { outcome: 'refused', problems };
    const text = withMappings(this.#document.text, mappings);
    const document = readDocument(text, this.protocol);
    this.#storage.write(text);
    this.#document = document;
    this.#text = text;
    return { outcome: 'saved' };
  }
}
