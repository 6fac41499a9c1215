/** A text file to download. */
export interface TextFile {
  readonly name: string;
  readonly text: string;
}

/** Replaces characters that file systems do not allow. */
export function fileName(name: string): string {
  return name
    .replaceAll(/[\\/:*?"<>|\p{Cc}]+/gu, '-')
    .replaceAll(/^[.\s-]+|[.\s-]+$/g, '')
    .slice(0, 100);
}
