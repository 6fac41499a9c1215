/** A file to be kept. */
export interface TextFile {
  readonly name: string;
  readonly text: string;
}

/** Without signs that file systems do not like. */
export function fileName(name: string): string {
  return name
    .replaceAll(/[\\/:*?"<>|\p{Cc}]+/gu, '-')
    .replaceAll(/^[.\s-]+|[.\s-]+$/g, '')
    .slice(0, 100);
}
