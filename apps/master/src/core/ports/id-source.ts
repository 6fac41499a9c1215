/** Gives new identifiers. */
export interface IdSource {
  /** A version 4 UUID in lower-case letters, never given before. */
  uuid(): string;

  /** The UUID (version 5) of a name: always the same, another for each name. */
  named(name: string): string;
}
