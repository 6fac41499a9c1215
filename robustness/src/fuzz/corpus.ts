import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

export const CORPUS_FOLDER = join(import.meta.dirname, '../../corpus');

/** Inputs that once did harm, in their order. The gate delivers them again. */
export interface Find {
  readonly entrance: string;
  /** The observed failure. */
  readonly reason: string;
  /** Base64. */
  readonly inputs: readonly string[];
  /** Owner of the fix, or the reason against one: then the gate reports the find without failing. */
  readonly todo?: string;
}

export interface KeptFind extends Find {
  readonly file: string;
}

export function readCorpus(): KeptFind[] {
  if (!existsSync(CORPUS_FOLDER)) return [];
  return readdirSync(CORPUS_FOLDER)
    .filter((name) => name.endsWith('.json'))
    .sort()
    .map((file) => ({
      file,
      ...(JSON.parse(readFileSync(join(CORPUS_FOLDER, file), 'utf8')) as Find),
    }));
}

/** @returns the name of its file */
export function keepFind(find: Find): string {
  const hash = createHash('sha256').update(find.inputs.join()).digest('hex').slice(0, 10);
  const file = `${find.entrance}-${hash}.json`;
  mkdirSync(CORPUS_FOLDER, { recursive: true });
  writeFileSync(join(CORPUS_FOLDER, file), `${JSON.stringify(find, undefined, 2)}\n`);
  return file;
}
