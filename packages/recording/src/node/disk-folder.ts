import { mkdir, readdir, rename, rm, stat, statfs } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { DiskFile } from './disk-file.ts';

import type { OpenFile, RecordingFolder } from '../recorder/recording-folder.ts';

const EXTENSION = '.mcap';
/** Uploads that are under way. */
const UPLOAD = '.upload';

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

/** Files of recordings in a folder of the disk, which is created with the first. */
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
    return names
      .filter((name) => name.endsWith(EXTENSION))
      .map((name) => name.slice(0, -EXTENSION.length));
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
    await mkdir(this.#path, { recursive: true });
    return DiskFile.create(recordingPath(this.#path, id));
  }

  open(id: string): Promise<OpenFile> {
    return DiskFile.open(recordingPath(this.#path, id));
  }

  edit(id: string): Promise<OpenFile> {
    return DiskFile.edit(recordingPath(this.#path, id));
  }

  delete(id: string): Promise<void> {
    return rm(recordingPath(this.#path, id), { force: true });
  }

  takeUpload(id: string): Promise<void> {
    return rename(uploadPath(this.#path, id), recordingPath(this.#path, id));
  }

  async freeBytes(): Promise<number> {
    const facts = await statfs(this.#path)
      .catch(() => statfs(dirname(this.#path)))
      .catch(() => undefined);
    return facts === undefined ? 0 : facts.bavail * facts.bsize;
  }
}
