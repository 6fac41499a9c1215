import { createHmac, randomBytes, randomInt, timingSafeEqual } from 'node:crypto';

import type { AccessSecrets } from '../../core/ports/index.ts';
import { deriveKey } from '../tokens/token-key.ts';

/** Random bytes of a token: 256 bits. */
const TOKEN_BYTES = 32;

/** Secrets of who may join, with keys that nothing else is signed with. [AC-11] [AC-13] [AC-66] */
export class HmacAccessSecrets implements AccessSecrets {
  readonly #signing: Uint8Array;
  readonly #hashing: Uint8Array;

  /** @param key at least 32 random bytes, secret; each use gets a key of its own made from it */
  constructor(key: Uint8Array) {
    this.#signing = deriveKey(key, 'credentials');
    this.#hashing = deriveKey(key, 'join secrets');
  }

  token(): string {
    return randomBytes(TOKEN_BYTES).toString('base64url');
  }

  numbers(count: number, below: number): readonly number[] {
    return Array.from({ length: count }, () => randomInt(below));
  }

  fingerprint(secret: string): string {
    return hash(this.#hashing, secret).toString('base64url');
  }

  sign(text: string): string {
    return hash(this.#signing, text).toString('base64url');
  }

  verify(text: string, signature: string): boolean {
    const expected = hash(this.#signing, text);
    const given = Buffer.from(signature, 'base64url');
    return given.length === expected.length && timingSafeEqual(given, expected);
  }
}

function hash(key: Uint8Array, text: string): Buffer {
  return createHmac('sha256', key).update(text).digest();
}
