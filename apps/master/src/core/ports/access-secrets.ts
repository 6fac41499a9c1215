/** Makes and proves the secrets of who may join. Keyed with a secret of the data directory. */
export interface AccessSecrets {
  /** A new token: at least 128 random bits, letters, digits, `-` and `_` only. */
  token(): string;
  /** `count` random numbers from 0 to `below - 1`, each as likely as the others. */
  numbers(count: number, below: number): readonly number[];
  /**
   * A keyed hash of a secret, the same in later runs: stored and looked up instead of the secret. A caller
   * without the key cannot choose a hash, so that comparing hashes reveals nothing about a secret.
   */
  fingerprint(secret: string): string;
  /** The proof that this text was written here, also by an earlier run of the master. */
  sign(text: string): string;
  /** Whether `signature` proves `text`. Takes the same time whether right or wrong. Never throws. */
  verify(text: string, signature: string): boolean;
}
