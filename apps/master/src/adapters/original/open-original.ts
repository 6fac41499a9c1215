import { basename, extname, join } from 'node:path';
import { readdir, stat } from 'node:fs/promises';
import { ServiceError, type JsonObject } from '@ubii/proto';
import type { Cancel } from '@ubii/timing';
import type { DocumentStore, StoredDocument, SessionStorage } from '../../core/ports/index.ts';
import type { OriginalFile, OriginalFolders } from './original-files.ts';
import { FolderWatch } from '../storage/folder-watch.ts';
import { foldersOf, readOriginal, type OriginalContext } from './read-original.ts';

/** Keys of files of the original: no key of this master has a slash at its start. */
const PREFIX = '/original/';

/**
 * The documents of this master over those of an original installation, which stay as they are: a change of one is
 * written as a document of this master, which hides the other. [SE-28]
 */
export class LayeredDocuments implements DocumentStore {
  readonly #own: DocumentStore;
  readonly #onClose: () => void;
  readonly #listeners = new Set<(keys: readonly string[]) => void>();
  #original: ReadonlyMap<string, OriginalFile>;
  #layered: {
    readonly own: ReadonlyMap<string, StoredDocument> | undefined;
    readonly all: ReadonlyMap<string, StoredDocument>;
  } = { own: undefined, all: new Map() };

  /** @param onClose called when this is closed */
  constructor(own: DocumentStore, original: readonly OriginalFile[], onClose = () => {}) {
    this.#own = own;
    this.#original = byKey(original);
    this.#onClose = onClose;
  }

  /** The files of the original were changed. */
  replace(original: readonly OriginalFile[]): void {
    const keys = [...new Set([...this.#original.keys(), ...byKey(original).keys()])];
    this.#original = byKey(original);
    this.#layered = { own: undefined, all: new Map() };
    for (const listener of this.#listeners) listener(keys);
  }

  documents(): ReadonlyMap<string, StoredDocument> {
    const own = this.#own.documents();
    if (own === this.#layered.own) return this.#layered.all;
    const all = new Map(own);
    const names = new Set([...own].map(([key, document]) => nameOf(document) ?? key));
    for (const [key, { path, document }] of this.#original) {
      const name = nameOf(document) ?? basename(path, extname(path));
      if (document.fault !== undefined || !names.has(name)) all.set(key, withName(document, name));
    }
    this.#layered = { own, all };
    return all;
  }

  describe(key: string): string {
    return this.#original.get(key)?.path ?? this.#own.describe(key);
  }

  write(key: string, json: JsonObject): Promise<void> {
    return this.#own.write(this.#original.has(key) ? String(json['name']) : key, json);
  }

  delete(key: string): Promise<void> {
    const path = this.#original.get(key)?.path;
    if (path === undefined) return this.#own.delete(key);
    return Promise.reject(
      new ServiceError(
        'failed_precondition',
        `It is a file of the original installation, which the master does not change. Delete ${path} yourself.`,
      ),
    );
  }

  onChange(fn: (keys: readonly string[]) => void): Cancel {
    const cancel = this.#own.onChange(fn);
    this.#listeners.add(fn);
    return () => {
      cancel();
      this.#listeners.delete(fn);
    };
  }

  close(): void {
    this.#own.close();
    this.#listeners.clear();
    this.#onClose();
  }
}

function byKey(files: readonly OriginalFile[]): Map<string, OriginalFile> {
  return new Map(files.map((file) => [`${PREFIX}${basename(file.path)}`, file]));
}

function nameOf({ json }: StoredDocument): string | undefined {
  const { name } = (json ?? {}) as { name?: unknown };
  return typeof name === 'string' && name !== '' ? name : undefined;
}

function withName(document: StoredDocument, name: string): StoredDocument {
  return document.fault === undefined ? { json: { ...(document.json as object), name } } : document;
}

/**
 * Puts sessions and modules of an original installation below those of a storage. Files that are changed by hand count
 * at once. [SE-28]
 *
 * @returns the storage itself without a folder
 * @throws ConfigError when the folder is none of an original installation
 */
export async function openOriginal<S extends Pick<SessionStorage, 'sessions' | 'modules'>>(
  storage: S,
  folder: string | undefined,
  context: OriginalContext,
): Promise<S> {
  if (folder === undefined) return storage;
  const folders = await foldersOf(folder);
  let stamp = await stampOf(folders);
  const data = await readOriginal(folders, context);
  const watches: FolderWatch[] = [];
  const close = (): void => {
    for (const watch of watches.splice(0)) watch.close();
  };
  const sessions = new LayeredDocuments(storage.sessions, data.sessions, close);
  const modules = new LayeredDocuments(storage.modules, data.modules, close);
  let reading = Promise.resolve();
  const look = async (): Promise<void> => {
    const newest = await stampOf(folders);
    if (newest === stamp) return;
    stamp = newest;
    const read = await readOriginal(folders, context);
    modules.replace(read.modules);
    sessions.replace(read.sessions);
  };
  for (const watched of [folders.sessions, folders.processing]) {
    if (watched === undefined) continue;
    const handleNotice = (): void => {
      reading = reading.then(look).catch((error: unknown) => {
        context.log.warn('the original installation cannot be read', { reason: String(error) });
      });
    };
    watches.push(new FolderWatch(watched, handleNotice));
  }
  return { ...storage, sessions, modules };
}

/** What a change of a file changes. */
async function stampOf({ sessions, processing }: OriginalFolders): Promise<string> {
  const stamps: string[] = [];
  for (const folder of [sessions, processing]) {
    // A folder that was removed has no files, which is told once by those who read it.
    const names = folder === undefined ? [] : await readdir(folder).catch(() => []);
    for (const name of names.sort()) {
      const stats = await stat(join(folder!, name)).catch(() => undefined);
      stamps.push(`${name} ${stats?.mtimeMs} ${stats?.size} ${stats?.ino}`);
    }
  }
  return stamps.join('\n');
}
