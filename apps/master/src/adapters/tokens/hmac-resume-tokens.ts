import { createHmac, timingSafeEqual } from 'node:crypto';

import type { ResumeTokens } from '../../core/ports/index.ts';
import { deriveKey } from './token-key.ts';

/** Tokens as keyed hashes of the client id: nothing needs to be stored per client. [EX-3] */
export class HmacResumeTokens implements ResumeTokens {
  readonly #key: Uint8Array;

  /** @param key at least 32 random bytes, secret; a key of its own is made from it */
  constructor(key: Uint8Array) {
    this.#key = deriveKey(key, 'resume tokens');
  }

  issue(clientId: string): string {
    return this.#hash(clientId).toString('base64url');
  }

  verify(clientId: string, token: string): boolean {
    const expected = this.#hash(clientId);
    const given = Buffer.from(token, 'base64url');
    return given.length === expected.length && timingSafeEqual(given, expected);
  }

  prove(clientId: string, text: string): string {
    return createHmac('sha256', this.issue(clientId)).update(text).digest('hex');
  }

  #hash(clientId: string): Buffer {
    return createHmac('sha256', this.#key).update(clientId).digest();
  }
}
