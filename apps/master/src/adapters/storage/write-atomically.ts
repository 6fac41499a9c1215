import { mkdir, open, rename, rm } from 'node:fs/promises';
import { dirname } from 'node:path';

let count = 0;

/**
 * Writes a file as a whole or not at all: into another one, which then takes its name. It is on the disk
 * when the promise is fulfilled.
 *
 * @param mode permissions of the file, before the mask of the process
 */
export async function writeAtomically(file: string, text: string, mode = 0o666): Promise<void> {
  const temporary = `${file}.${process.pid}.${++count}.tmp`;
  await mkdir(dirname(file), { recursive: true });
  try {
    const handle = await open(temporary, 'w', mode);
    try {
      await handle.writeFile(text);
      await handle.sync();
    } finally {
      await handle.close();
    }
    await rename(temporary, file);
  } catch (error) {
    await rm(temporary, { force: true });
    throw error;
  }
  await syncFolder(dirname(file));
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
