/** Gives new identifiers. */
export interface IdSource {
  /** A version 4 UUID in lower-case letters, never given before. */
  uuid(): string;
}
