import { mkdirSync, readdirSync, readFileSync, statSync } from 'node:fs';
import { rm } from 'node:fs/promises';
import { join } from 'node:path';
import { SECRET_MODE, writeAtomically } from '@ubii/program';
import type { JsonObject } from '@ubii/proto';
import type { Cancel } from '@ubii/timing';
import type { DocumentStore, StoredDocument } from '../../core/ports/index.ts';
import { FolderWatch } from './folder-watch.ts';

/** Characters that Windows, macOS or Linux do not allow in a filename, and the escape character itself. */
// eslint-disable-next-line no-control-regex -- control characters are among them
const UNSAFE = /[\u0000-\u001f\u007f<>:"/\\|?*%]|^\.|[. ]$/gu;
/** Names that Windows keeps for devices. */
const RESERVED = /^(con|prn|aux|nul|com\d|lpt\d)$/i;
/** File systems take 255 bytes of UTF-8, and an extension and a number follow. */
const MAX_BYTES = 200;

/** The filename of a document, without its extension: the key, escaped as in a URL where needed [SE-20]. */
export function fileNameOf(key: string): string {
  const escaped = (RESERVED.test(key) ? `%${hex(key[0]!)}${key.slice(1)}` : key).replace(
    UNSAFE,
    (char, offset: number) => (RESERVED.test(key) && offset === 0 ? char : `%${hex(char)}`),
  );
  if (Buffer.byteLength(escaped) <= MAX_BYTES) return escaped || '%';
  return `${cut(escaped)}%${hash(key)}`;
}

/** The key of a filename; what was cut off is not known, which the name inside makes up for. */
export function keyOfFileName(fileName: string): string {
  return fileName.replace(/%([0-9a-f]{2})/gi, (_, digits: string) =>
    String.fromCharCode(Number.parseInt(digits, 16)),
  );
}

function hex(char: string): string {
  return char.charCodeAt(0).toString(16).padStart(2, '0');
}

function cut(text: string): string {
  let length = 0;
  let cutText = '';
  for (const char of text) {
    length += Buffer.byteLength(char);
    if (length > MAX_BYTES) break;
    cutText += char;
  }
  return cutText;
}

/** FNV-1a, to tell long names apart that begin alike. */
function hash(text: string): string {
  let value = 0x811c9dc5;
  for (let i = 0; i < text.length; i++) {
    value = Math.imul(value ^ text.charCodeAt(i), 0x01000193) >>> 0;
  }
  return value.toString(36);
}

/** Largest file that is read, bytes: a whole session with its code takes some hundred KiB. */
const MAX_FILE_BYTES = 32 * 1024 * 1024;

interface KnownFile {
  /** Time, size and number: what a change of the file changes. */
  readonly stamp: string;
  readonly key: string;
  readonly document: StoredDocument;
}

/** A folder of JSON files, one a document, which people may edit while the master runs [SE-20] [SE-23]. */
export class FileDocuments implements DocumentStore {
  readonly #folder: string;
  readonly #extension: string;
  readonly #fileMode: number;
  readonly #listeners = new Set<(keys: readonly string[]) => void>();
  readonly #watch: FolderWatch;
  #files = new Map<string, KnownFile>();
  #documents = new Map<string, StoredDocument>();
  /** Writes follow one another: the last one wins, whatever the disk does. */
  #queue: Promise<void> = Promise.resolve();

  /**
   * @param folder made when it is missing
   * @param extension of its files, with the dot
   * @param isSecret only the owner of the process can read folder and files. Default: false
   */
  constructor(folder: string, extension: string, isSecret = false) {
    this.#folder = folder;
    this.#extension = extension;
    this.#fileMode = isSecret ? SECRET_MODE : 0o666;
    mkdirSync(folder, { recursive: true, mode: isSecret ? 0o700 : 0o777 });
    this.#scan();
    this.#watch = new FolderWatch(folder, () => this.#handleChange());
  }

  documents(): ReadonlyMap<string, StoredDocument> {
    return this.#documents;
  }

  describe(key: string): string {
    return join(this.#folder, this.#fileOf(key));
  }

  write(key: string, json: JsonObject): Promise<void> {
    return this.#enqueue(async () => {
      const text = `${JSON.stringify(json, undefined, 2)}\n`;
      await writeAtomically(this.describe(key), text, this.#fileMode);
    });
  }

  delete(key: string): Promise<void> {
    return this.#enqueue(() => rm(this.describe(key), { force: true }));
  }

  onChange(fn: (keys: readonly string[]) => void): Cancel {
    this.#listeners.add(fn);
    return () => this.#listeners.delete(fn);
  }

  close(): void {
    this.#watch.close();
    this.#listeners.clear();
  }

  /** Resolves when the queue is empty. */
  async settled(): Promise<void> {
    await this.#queue;
  }

  #enqueue(work: () => Promise<void>): Promise<void> {
    const done = this.#queue.then(async () => {
      await work();
      this.#scan();
    });
    this.#queue = done.catch(() => undefined);
    return done;
  }

  #handleChange(): void {
    const changed = this.#scan();
    if (changed.length === 0) return;
    for (const listener of this.#listeners) listener(changed);
  }

  /** Reads what has changed. @returns the keys of it */
  #scan(): string[] {
    const files = new Map<string, KnownFile>();
    const changed: string[] = [];
    for (const name of this.#names()) {
      const known = this.#files.get(name);
      const stamp = this.#stamp(name);
      if (stamp === undefined) continue;
      const file = known?.stamp === stamp ? known : this.#read(name, stamp);
      if (file !== known) changed.push(file.key);
      files.set(name, file);
    }
    for (const [name, { key }] of this.#files) if (!files.has(name)) changed.push(key);
    this.#files = files;
    if (changed.length > 0) {
      this.#documents = new Map([...files.values()].map(({ key, document }) => [key, document]));
    }
    return changed;
  }

  #names(): string[] {
    try {
      return readdirSync(this.#folder)
        .filter((name) => name.endsWith(this.#extension) && !name.startsWith('.'))
        .sort();
    } catch {
      // The folder was removed: there are no documents until the next write.
      return [];
    }
  }

  #stamp(name: string): string | undefined {
    try {
      const stats = statSync(join(this.#folder, name), { bigint: true });
      return `${stats.mtimeNs} ${stats.size} ${stats.ino}`;
    } catch {
      return undefined;
    }
  }

  #read(name: string, stamp: string): KnownFile {
    const key = keyOfFileName(name.slice(0, -this.#extension.length));
    try {
      const path = join(this.#folder, name);
      const { size } = statSync(path);
      if (size > MAX_FILE_BYTES) return { stamp, key, document: { fault: `it has ${size} bytes` } };
      return { stamp, key, document: { json: JSON.parse(readFileSync(path, 'utf8')) as unknown } };
    } catch (error) {
      const reason = error instanceof Error ? error.message : String(error);
      return { stamp, key, document: { fault: reason } };
    }
  }

  /** The file that has the document of this key, or would have it. */
  #fileOf(key: string): string {
    for (const [name, file] of this.#files) if (file.key === key) return name;
    return `${fileNameOf(key)}${this.#extension}`;
  }
}
