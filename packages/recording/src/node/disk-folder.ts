import {
  chmod,
  readdir,
  stat,
  mkdir,
  readFile,
  rename,
  rm,
  statfs,
  writeFile,
} from 'node:fs/promises';
import { join, dirname } from 'node:path';

import {
  formatRejection,
  parseRejection,
  type OpenFile,
  type RecordingFolder,
  type RejectedFile,
  type Rejection,
} from '../recorder/recording-folder.ts';
import { DiskFile } from './disk-file.ts';

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

const EXTENSION = '.mcap';
/** Uploads that are under way, or not checked yet. */
const UPLOAD = '.upload';
/** Files that were refused, and why. [RC-45] */
const REJECTED = '.rejected';
const REJECTION = '.rejected.json';
/** Longest note of a rejection that is read. */
const MAX_REJECTION_BYTES = 64 * 1024;

/** Where the recordings of a data directory are. */
export function recordingsFolder(dataDir: string): string {
  return join(dataDir, 'recordings');
}

/** Path of a recording. @param id only letters, digits and `-` */
export function recordingPath(folder: string, id: string): string {
  return join(folder, `${id}${EXTENSION}`);
}

/** Path of an upload that is under way. */
export function uploadPath(folder: string, id: string): string {
  return join(folder, `${id}${UPLOAD}`);
}

/** Files of recordings in a folder of the disk, which is created with the first, for its owner alone. [RC-46] */
export class DiskFolder implements RecordingFolder {
  readonly #path: string;

  constructor(path: string) {
    this.#path = path;
  }

  async list(): Promise<string[]> {
    const names = await readdir(this.#path).catch(() => []);
    // Uploads of earlier runs; the list is asked for before the first of this run. [RC-42]
    const left = names.filter((name) => name.endsWith(UPLOAD));
    await Promise.all(left.map((name) => rm(join(this.#path, name), { force: true })));
    return idsOf(names, EXTENSION);
  }

  async has(id: string): Promise<boolean> {
    try {
      await stat(recordingPath(this.#path, id));
      return true;
    } catch (error) {
      if ((error as NodeJS.ErrnoException).code === 'ENOENT') return false;
      throw error;
    }
  }

  async create(id: string): Promise<OpenFile> {
    await mkdir(this.#path, { recursive: true, mode: OWNER_FOLDER_MODE });
    return DiskFile.create(recordingPath(this.#path, id), OWNER_FILE_MODE);
  }

  open(id: string): Promise<OpenFile> {
    return DiskFile.open(recordingPath(this.#path, id));
  }

  edit(id: string): Promise<OpenFile> {
    return DiskFile.edit(recordingPath(this.#path, id));
  }

  async delete(id: string): Promise<void> {
    await Promise.all(
      [EXTENSION, REJECTED, REJECTION].map((end) => rm(this.#pathOf(id, end), { force: true })),
    );
  }

  editUpload(id: string): Promise<OpenFile> {
    return DiskFile.edit(uploadPath(this.#path, id));
  }

  takeUpload(id: string): Promise<void> {
    return rename(uploadPath(this.#path, id), recordingPath(this.#path, id));
  }

  dropUpload(id: string): Promise<void> {
    return rm(uploadPath(this.#path, id), { force: true });
  }

  async reject(
    id: string,
    from: 'recording' | 'upload',
    rejection: Rejection,
  ): Promise<RejectedFile> {
    // The reason first: a file without its new name is checked again.
    await writeFile(this.#pathOf(id, REJECTION), formatRejection(rejection), {
      mode: OWNER_FILE_MODE,
    });
    const path = this.#pathOf(id, REJECTED);
    await rename(this.#pathOf(id, from === 'upload' ? UPLOAD : EXTENSION), path);
    return { id, sizeBytes: (await stat(path)).size, rejection };
  }

  async rejected(): Promise<RejectedFile[]> {
    const names = await readdir(this.#path).catch(() => []);
    return Promise.all(idsOf(names, REJECTED).map((id) => this.#readRejected(id)));
  }

  async freeBytes(): Promise<number> {
    const facts = await statfs(this.#path)
      .catch(() => statfs(dirname(this.#path)))
      .catch(() => undefined);
    return facts === undefined ? 0 : facts.bavail * facts.bsize;
  }

  async #readRejected(id: string): Promise<RejectedFile> {
    const note = this.#pathOf(id, REJECTION);
    const noteBytes = await stat(note).then(
      ({ size }) => size,
      () => 0,
    );
    const text =
      noteBytes <= MAX_REJECTION_BYTES ? await readFile(note, 'utf8').catch(() => '') : '';
    const { size: sizeBytes } = await stat(this.#pathOf(id, REJECTED));
    return { id, sizeBytes, rejection: parseRejection(text) };
  }

  #pathOf(id: string, end: string): string {
    return join(this.#path, `${id}${end}`);
  }
}

function idsOf(names: readonly string[], end: string): string[] {
  return names.filter((name) => name.endsWith(end)).map((name) => name.slice(0, -end.length));
}
