/** Proves that a client is the one that was given an id earlier, also by an earlier run of the master. */
export interface ResumeTokens {
  /** The token of this id. The same id has the same token as long as the key stands. */
  issue(clientId: string): string;
  /** Whether `token` was issued for `clientId`. Takes the same time whether right or wrong. Never throws. */
  verify(clientId: string, token: string): boolean;
  /**
   * HMAC-SHA-256 of `text` with the token of this id as the key, in hexadecimal: shows who has that token that this
   * master could have issued it.
   */
  prove(clientId: string, text: string): string;
}
