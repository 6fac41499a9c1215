import { readdir, readFile, stat } from 'node:fs/promises';
import { extname, join } from 'node:path';

import { ConfigError } from '@ubii/program';
import type { StoredDocument } from '../../core/ports/index.ts';

/** Files that are read of a folder. */
export const MAX_FILES = 1000;
/** Largest file, bytes: no session or module may be larger. */
const MAX_FILE_BYTES = 8 * 1024 * 1024;
/** Bytes of all files of a folder. */
const MAX_FOLDER_BYTES = 64 * 1024 * 1024;

/** A file of an original installation, and what it holds. */
export interface OriginalFile {
  readonly path: string;
  readonly document: StoredDocument;
}

/** Returns what the text of a file holds, as JSON. @throws Error with one sentence */
export type FileReader = (text: string) => unknown;

type FileReaders = Readonly<Record<string, FileReader>>;

/** Folders of an original installation; a folder that it does not have is undefined. */
export interface OriginalFolders {
  readonly sessions: string | undefined;
  readonly processing: string | undefined;
}

/**
 * Finds the folders `sessions` and `processing` in a folder, or in `database` in it, where recent masters have them.
 *
 * @returns undefined when it has neither
 */
export async function findOriginalFolders(folder: string): Promise<OriginalFolders | undefined> {
  for (const base of [join(folder, 'database'), folder]) {
    const sessions = await folderAt(join(base, 'sessions'));
    const processing = await folderAt(join(base, 'processing'));
    if (sessions !== undefined || processing !== undefined) return { sessions, processing };
  }
  return undefined;
}

/** @throws ConfigError when the data directory of this master is one of an original installation [SE-28] */
export async function refuseOriginal(dataDir: string): Promise<void> {
  const found = await findOriginalFolders(dataDir);
  const isInRoot = found?.sessions !== join(dataDir, 'sessions');
  if (found === undefined || (found.processing === undefined && !isInRoot)) return;
  throw new ConfigError(
    `The data directory ${dataDir} (--data-dir) is that of an original Ubi-Interact, whose files stay as they are: use --original-data ${dataDir} to read it, and another folder for --data-dir.`,
  );
}

/**
 * Reads the files of a folder whose ending has a reader, from a to z. Nothing is written. What cannot be read is a
 * document with a fault.
 *
 * @param readers by ending, with the dot
 */
export async function readFiles(folder: string, readers: FileReaders): Promise<OriginalFile[]> {
  const names = (await readdir(folder))
    .filter((name) => !name.startsWith('.') && Object.hasOwn(readers, extname(name)))
    .sort();
  const files: OriginalFile[] = [];
  const budget = { bytes: MAX_FOLDER_BYTES };
  for (const name of names.slice(0, MAX_FILES)) {
    const path = join(folder, name);
    files.push({ path, document: await readOne(path, readers[extname(name)]!, budget) });
  }
  if (names.length > MAX_FILES) {
    const fault = `it has ${names.length} files, of which the first ${MAX_FILES} are read`;
    files.push({ path: folder, document: { fault } });
  }
  return files;
}

async function readOne(
  path: string,
  read: FileReader,
  budget: { bytes: number },
): Promise<StoredDocument> {
  try {
    const stats = await stat(path);
    if (!stats.isFile()) return { fault: 'it is not a file' };
    const limit = Math.min(MAX_FILE_BYTES, budget.bytes);
    if (stats.size > limit) {
      return { fault: `it has ${stats.size} bytes; at most ${limit} more are read` };
    }
    budget.bytes -= stats.size;
    return { json: await read(await readFile(path, 'utf8')) };
  } catch (error) {
    return { fault: error instanceof Error ? error.message : String(error) };
  }
}

async function folderAt(path: string): Promise<string | undefined> {
  try {
    return (await stat(path)).isDirectory() ? path : undefined;
  } catch {
    return undefined;
  }
}
