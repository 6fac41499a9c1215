import { readPictureFile } from '@ubii/pictures';
import { isCompressedImage } from '@ubii/proto';
import { base64Of, bytesOfBase64 } from './base64.ts';

/** What is shown of the picture in a message. */
export interface PicturePreview {
  /** Address for an `img`. */
  readonly url?: string;
  /** Why the file is not shown, one sentence. */
  readonly problem?: string;
}

/**
 * Returns what to show of the `data` of an `Image2D` in JSON, which another client may have written [EX-98]; undefined for
 * raw pixels.
 */
export function previewOf(data: unknown): PicturePreview | undefined {
  const bytes = typeof data === 'string' ? bytesOfBase64(data) : undefined;
  if (!bytes || !isCompressedImage(bytes)) return undefined;
  try {
    const file = readPictureFile(bytes);
    return { url: `data:image/${file.format.toLowerCase()};base64,${base64Of(file.data)}` };
  } catch (error) {
    return { problem: error instanceof Error ? error.message : String(error) };
  }
}
