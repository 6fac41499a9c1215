import { watch } from 'node:fs';
import { loadModuleFolder, type LoadedFolder } from './load-module-folder.ts';

/** Editors write a file in several steps; it is read when they have been quiet for this long, milliseconds. */
const QUIET_MS = 100;

/** A folder that is being watched. */
export interface FolderWatch {
  /** Initial contents. */
  readonly loaded: LoadedFolder;
  close(): void;
}

/**
 * Loads the modules of a folder, and again whenever it changes.
 *
 * @param onChange what it holds now; not called for the first load
 * @param onError it could not be read or watched, and will not be any more
 * @throws Error when the folder cannot be read
 */
export async function watchModuleFolder(
  folder: string,
  onChange: (loaded: LoadedFolder) => void,
  onError: (error: Error) => void,
): Promise<FolderWatch> {
  let timer: NodeJS.Timeout | undefined;
  let isClosed = false;
  let reading = Promise.resolve();
  // Before the first load, so that no change falls between the two.
  const watcher = watch(folder, () => {
    clearTimeout(timer);
    timer = setTimeout(() => {
      reading = reading.then(read);
    }, QUIET_MS);
  });
  const close = (): void => {
    isClosed = true;
    clearTimeout(timer);
    watcher.close();
  };
  const fail = (error: unknown): void => {
    if (isClosed) return;
    close();
    onError(error instanceof Error ? error : new Error(String(error)));
  };
  const read = async (): Promise<void> => {
    try {
      const loaded = await loadModuleFolder(folder);
      if (!isClosed) onChange(loaded);
    } catch (error) {
      fail(error);
    }
  };
  watcher.on('error', fail);
  try {
    return { loaded: await loadModuleFolder(folder), close };
  } catch (error) {
    close();
    throw error;
  }
}
