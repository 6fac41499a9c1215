/**
 * Proves that a message between masters comes from one that has the key of the cluster. A proof is worth nothing for another
 * sender or receiver. [CU-65]
 */
export interface MessageSeal {
  /**
   * Proves a message.
   *
   * @param to the master that receives it; empty when all do
   * @returns 32 bytes
   */
  prove(from: string, to: string, message: Uint8Array): Uint8Array;
  /** Whether `proof` proves this message. Takes the same time whether right or wrong. Never throws. */
  verify(from: string, to: string, message: Uint8Array, proof: Uint8Array): boolean;
}
