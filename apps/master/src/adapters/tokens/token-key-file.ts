import { readFileSync } from 'node:fs';
import { join } from 'node:path';

import { ConfigError, createAtomicallySync, SECRET_MODE } from '@ubii/program';

import { createTokenKey, parseTokenKey, TOKEN_KEY_BYTES } from './token-key.ts';

const FILE_NAME = 'resume-token.key';

/**
 * The secret key of this data directory, made at the first start and readable by its owner only.
 * Deleting the file makes every client a new one.
 *
 * @throws ConfigError when the file holds something else
 */
export function readOrCreateTokenKey(dataDir: string, fileName = FILE_NAME): Uint8Array {
  const file = join(dataDir, fileName);
  const kept = readKey(file);
  if (kept !== undefined) return kept;
  // Two masters may start at once: the file of the first one stays.
  createAtomicallySync(file, `${createTokenKey()}\n`, SECRET_MODE);
  const key = readKey(file);
  if (key === undefined)
    throw new ConfigError(`The key file ${file} was removed while it was created.`);
  return key;
}

function readKey(file: string): Uint8Array | undefined {
  let text: string;
  try {
    text = readFileSync(file, 'utf8').trim();
  } catch (error) {
    if ((error as NodeJS.ErrnoException).code === 'ENOENT') return undefined;
    throw error;
  }
  const key = parseTokenKey(text);
  if (key === undefined) {
    throw new ConfigError(
      `The key file ${file} must hold ${TOKEN_KEY_BYTES} bytes in hexadecimal, but does not. Delete it; every client then joins as a new one.`,
    );
  }
  return key;
}
