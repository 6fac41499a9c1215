import {
  readFileSync,
  realpathSync,
  statSync,
  writeFileSync,
  unwatchFile,
  watchFile,
} from 'node:fs';
import { createHash } from 'node:crypto';
import { resolve } from 'node:path';
import { writeAtomicallySync, ConfigError } from '@ubii/program';
import { type MappingStorage, MappingStore } from './core/mapping/mapping-store.ts';
import type { Protocol } from './core/mapping/mapping.ts';

/** A mapping file on the disk. A link to one stays a link. */
function createFileStorage(path: string): MappingStorage {
  return {
    path,
    read() {
      try {
        return readFileSync(path, 'utf8');
      } catch (error) {
        if (codeOf(error) === 'ENOENT') return undefined;
        throw new Error(`It cannot be read: ${(error as Error).message}.`, { cause: error });
      }
    },
    write(text) {
      const { file, mode } = targetOf(path);
      try {
        writeAtomicallySync(file, text, mode);
      } catch (error) {
        // A file that is mounted into a container cannot be replaced, only written.
        if (codeOf(error) !== 'EBUSY') throw error;
        writeFileSync(file, text);
      }
    },
  };
}

function targetOf(path: string): { readonly file: string; readonly mode?: number } {
  try {
    const file = realpathSync(path);
    return { file, mode: statSync(file).mode & 0o777 };
  } catch (error) {
    if (codeOf(error) === 'ENOENT') return { file: path };
    throw error;
  }
}

function codeOf(error: unknown): string | undefined {
  return (error as NodeJS.ErrnoException).code;
}

/** Where mappings are, unless `--mapping` says another file. */
const DEFAULT_FILE = 'bridge.json';

const POLL_MS = 500;

const EXAMPLE = `{
  "version": 1,
  "mappings": [
    { "direction": "in", "foreign": "sensors/+/temp", "topic": "/mqtt/{1}/temp", "format": "double" }
  ]
}`;

/**
 * Opens the mapping file. Without `file`, it is the default one, which need not exist: the first mapping that a page saves
 * creates it. [BR-83]
 *
 * @throws ConfigError with the file and what is wrong with it
 */
export function openMappingStore(file: string | undefined, protocol: Protocol): MappingStore {
  const path = file ?? resolve(DEFAULT_FILE);
  let store: MappingStore;
  try {
    store = new MappingStore({ protocol, storage: createFileStorage(path), digest });
  } catch (error) {
    throw new ConfigError(`${path}: ${(error as Error).message}`);
  }
  if (file === undefined || store.fileExists) return store;
  throw new ConfigError(
    `The mapping file ${file} (--mapping) does not exist. Create it, for example:\n${EXAMPLE}`,
  );
}

/** Calls `fn` after each change of the file. [BR-4] @returns ends it */
export function watchMappingFile(store: MappingStore, fn: () => void): () => void {
  const listener = (): void => {
    store.refresh();
    fn();
  };
  // Polls the file: editors replace files, and not all systems report that.
  watchFile(store.path, { interval: POLL_MS, persistent: false }, listener);
  return () => unwatchFile(store.path, listener);
}

function digest(text: string): string {
  return createHash('sha256').update(text).digest('hex').slice(0, 16);
}
