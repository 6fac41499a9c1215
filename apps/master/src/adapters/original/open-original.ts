import { readdir, stat } from 'node:fs/promises';
import { join } from 'node:path';

import type { SessionStorage } from '../../core/ports/index.ts';
import { FolderWatch } from '../storage/folder-watch.ts';
import { LayeredDocuments } from './layered-documents.ts';
import type { OriginalFolders } from './original-files.ts';
import { foldersOf, readOriginal, type OriginalContext } from './read-original.ts';

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
