import { hkdfSync, randomBytes } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { ConfigError, createAtomicallySync, SECRET_MODE } from '@ubii/program';

/** Purpose of a key; each purpose has its own key. */
type KeyPurpose =
  | 'resume tokens'
  | 'credentials'
  | 'join secrets'
  | 'installation'
  | 'cluster messages';

const KEY_BYTES = 32;
/** Tells keys of this program, made in this way, from all others. */
const SALT = 'ubi-interact master keys 1';

/**
 * The key for one purpose, with HKDF-SHA-256 (RFC 5869). Nothing is signed with the raw key, and no
 * derived key tells anything about another.
 *
 * @param key at least 32 random bytes, secret
 */
export function deriveKey(key: Uint8Array, purpose: KeyPurpose): Uint8Array {
  return new Uint8Array(hkdfSync('sha256', key, SALT, `ubi-interact ${purpose}`, KEY_BYTES));
}

/** Bytes of the key that all secrets of a master are derived from. */
export const TOKEN_KEY_BYTES = 32;

/** A new key as it is stored: hexadecimal digits. */
export function createTokenKey(): string {
  return randomBytes(TOKEN_KEY_BYTES).toString('hex');
}

/** @returns undefined for a text that is not a key */
export function parseTokenKey(text: string): Uint8Array | undefined {
  return /^[0-9a-f]{64}$/.test(text) ? Buffer.from(text, 'hex') : undefined;
}

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
