import type { TextFile } from './text-file.ts';

/** Hands a file to the browser, which keeps it where it keeps downloads. */
export function saveFile({ name, text }: TextFile): void {
  saveBlob(name, new Blob([text], { type: 'application/json' }));
}

/** The same for what is no text, such as a picture. */
export function saveBlob(name: string, blob: Blob): void {
  const url = URL.createObjectURL(blob);
  const link = document.createElement('a');
  link.href = url;
  link.download = name;
  link.click();
  // The download has begun by then; the bytes are the browser's.
  setTimeout(() => URL.revokeObjectURL(url), 0);
}
