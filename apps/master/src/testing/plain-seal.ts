import type { MessageSeal } from '../core/ports/message-seal.ts';

const PROOF_BYTES = 32;

/** Proofs for tests: a sum of sender, receiver and message. All have the same key. */
export class PlainSeal implements MessageSeal {
  prove(from: string, to: string, message: Uint8Array): Uint8Array {
    const proof = new Uint8Array(PROOF_BYTES).fill(1);
    const bytes = Buffer.concat([Buffer.from(`${from}\n${to}\n`), message]);
    bytes.forEach((byte, index) => {
      const place = index % PROOF_BYTES;
      proof[place] = (proof[place]! * 31 + byte) & 0xff;
    });
    return proof;
  }

  verify(from: string, to: string, message: Uint8Array, proof: Uint8Array): boolean {
    return Buffer.compare(this.prove(from, to, message), proof) === 0;
  }
}
