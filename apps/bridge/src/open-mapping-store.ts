import { createHash } from 'node:crypto';
import { unwatchFile, watchFile } from 'node:fs';
import { resolve } from 'node:path';
import { ConfigError } from '@ubii/program';
import type { Protocol } from './core/mapping/mapping.ts';
import { MappingStore } from './core/mapping/mapping-store.ts';
import { createFileStorage } from './file-storage.ts';

/** Where mappings are, unless `--mapping` says another file. */
export const DEFAULT_FILE = 'bridge.json';

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
