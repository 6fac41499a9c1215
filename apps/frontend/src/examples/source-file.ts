/** A source file of an example. */
export interface SourceFile {
  /** Its purpose in one word. */
  readonly name: string;
  readonly fileName: string;
  readonly load: () => Promise<string>;
}
