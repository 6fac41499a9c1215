/** Formats of compressed pictures. */
export type PictureFileFormat = 'JPEG' | 'PNG' | 'WebP';

/**
 * Returns the format of a compressed picture by its first bytes; undefined for other data.
 *
 * Sources: ITU-T T.81 B.1.1.3 (JPEG), RFC 2083 3.1 (PNG), RFC 9649 2.4 (WebP).
 */
export function pictureFormatOf(data: ArrayLike<number>): PictureFileFormat | undefined {
  const has = (at: number, ...bytes: number[]): boolean =>
    bytes.every((byte, index) => data[at + index] === byte);
  if (has(0, 0xff, 0xd8, 0xff)) return 'JPEG';
  if (has(0, 0x89, 0x50, 0x4e, 0x47)) return 'PNG';
  if (has(0, 0x52, 0x49, 0x46, 0x46) && has(8, 0x57, 0x45, 0x42, 0x50)) return 'WebP';
  return undefined;
}
