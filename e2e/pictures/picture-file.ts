import { fileURLToPath } from 'node:url';

/** Path of a picture that the documents show. */
export function pictureFile(name: string): string {
  return fileURLToPath(new URL(`../../docs/pictures/${name}.png`, import.meta.url));
}
