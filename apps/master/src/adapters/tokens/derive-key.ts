import { hkdfSync } from 'node:crypto';

/** Purpose of a key; each purpose has its own key. */
export type KeyPurpose =
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
