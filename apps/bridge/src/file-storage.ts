import { readFileSync, realpathSync, statSync, writeFileSync } from 'node:fs';
import { writeAtomicallySync } from '@ubii/program';
import type { MappingStorage } from './core/mapping/mapping-store.ts';

/** A mapping file on the disk. A link to one stays a link. */
export function createFileStorage(path: string): MappingStorage {
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
