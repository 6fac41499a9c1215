import { chmod, readdir, stat } from 'node:fs/promises';
import { join } from 'node:path';

/** Modes of a file and of a folder that only their owner can read. [RC-46] */
export const OWNER_FILE_MODE = 0o600;
export const OWNER_FOLDER_MODE = 0o700;

const OTHERS = 0o077;

/**
 * Makes a folder and the files in it readable by their owner alone, as earlier versions did not. Files of other owners
 * stay as they are. Does nothing where there is no folder, and on systems without such modes.
 */
export async function keepToOwner(folder: string): Promise<void> {
  if (process.platform === 'win32') return;
  await restrict(folder, OWNER_FOLDER_MODE);
  for (const entry of await readdir(folder, { withFileTypes: true }).catch(() => [])) {
    if (entry.isFile()) await restrict(join(folder, entry.name), OWNER_FILE_MODE);
  }
}

async function restrict(path: string, mode: number): Promise<void> {
  try {
    if (((await stat(path)).mode & OTHERS) !== 0) await chmod(path, mode);
  } catch {
    // It is missing, or of another owner.
  }
}
