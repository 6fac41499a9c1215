import { randomBytes } from 'node:crypto';

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
