import { createHmac, timingSafeEqual } from 'node:crypto';

import type { MessageSeal } from '../../core/ports/index.ts';
import { deriveKey } from '../tokens/derive-key.ts';

/** Proofs with a key made from that of the cluster, which signs nothing else. [CU-65] */
export class HmacMessageSeal implements MessageSeal {
  readonly #key: Uint8Array;

  /** @param key the secret of the cluster, at least 32 random bytes */
  constructor(key: Uint8Array) {
    this.#key = deriveKey(key, 'cluster messages');
  }

  prove(from: string, to: string, message: Uint8Array): Uint8Array {
    // Ids of masters have no line ends.
    return createHmac('sha256', this.#key).update(`${from}\n${to}\n`).update(message).digest();
  }

  verify(from: string, to: string, message: Uint8Array, proof: Uint8Array): boolean {
    const expected = this.prove(from, to, message);
    return proof.byteLength === expected.byteLength && timingSafeEqual(proof, expected);
  }
}
