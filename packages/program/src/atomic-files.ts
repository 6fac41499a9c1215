import { randomBytes } from 'node:crypto';
import { linkSync, mkdirSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { mkdir, open, rename, rm } from 'node:fs/promises';
import { dirname } from 'node:path';

/** Mode of a file that only its owner can read. A folder that is created for it is its owner's alone, too. */
export const SECRET_MODE = 0o600;

/**
 * Writes a file as a whole or not at all, and creates its folder. A link in its place is replaced, not followed. The
 * file is on the disk when the promise is fulfilled.
 *
 * @param mode permissions of the file, before the mask of the process
 */
export async function writeAtomically(file: string, text: string, mode = 0o666): Promise<void> {
  const draft = draftOf(file);
  await mkdir(dirname(file), { recursive: true, mode: folderMode(mode) });
  try {
    const handle = await open(draft, 'wx', mode);
    try {
      await handle.writeFile(text);
      await handle.sync();
    } finally {
      await handle.close();
    }
    await rename(draft, file);
  } catch (error) {
    await rm(draft, { force: true });
    throw error;
  }
  await syncFolder(dirname(file));
}

/** As `writeAtomically`, before it returns, and without waiting for the disk. For small files at a start. */
export function writeAtomicallySync(file: string, text: string, mode = 0o666): void {
  withDraft(file, text, mode, (draft) => renameSync(draft, file));
}

/**
 * Creates a file as a whole, unless it exists: of programs that start at once, the first one creates it.
 *
 * @returns false when the file exists
 */
export function createAtomicallySync(file: string, text: string, mode = 0o666): boolean {
  return withDraft(file, text, mode, (draft) => {
    try {
      linkSync(draft, file);
      return true;
    } catch (error) {
      if ((error as NodeJS.ErrnoException).code === 'EEXIST') return false;
      throw error;
    }
  });
}

function withDraft<T>(file: string, text: string, mode: number, use: (draft: string) => T): T {
  const draft = draftOf(file);
  mkdirSync(dirname(file), { recursive: true, mode: folderMode(mode) });
  try {
    writeFileSync(draft, text, { mode, flag: 'wx' });
    return use(draft);
  } finally {
    rmSync(draft, { force: true });
  }
}

/** Beside the file, and with a name that no other program can guess and occupy. */
function draftOf(file: string): string {
  return `${file}.${process.pid}.${randomBytes(4).toString('hex')}.tmp`;
}

/** Users that can read a file can enter its folder. */
function folderMode(fileMode: number): number {
  return fileMode | ((fileMode & 0o444) >> 2);
}

/** The new name is on the disk when its folder is; systems that cannot do it do it themselves. */
async function syncFolder(folder: string): Promise<void> {
  try {
    const handle = await open(folder, 'r');
    try {
      await handle.sync();
    } finally {
      await handle.close();
    }
  } catch {
    // Windows opens no folders.
  }
}
