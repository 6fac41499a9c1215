/** A source file that an example shows. */
export interface SourceFile {
  /** What it is for: one word. */
  readonly name: string;
  readonly fileName: string;
  readonly load: () => Promise<string>;
}
