import type { TextFile } from './text-file.ts';

/** Downloads a text file. */
export function saveFile({ name, text }: TextFile): void {
  saveBlob(name, new Blob([text], { type: 'application/json' }));
}

/** Downloads binary data, such as a picture. */
export function saveBlob(name: string, blob: Blob): void {
  const url = URL.createObjectURL(blob);
  const link = document.createElement('a');
  link.href = url;
  link.download = name;
  link.click();
  // Revoke after the download has started.
  setTimeout(() => URL.revokeObjectURL(url), 0);
}
