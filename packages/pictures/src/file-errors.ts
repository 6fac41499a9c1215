import type { PictureFileFormat } from './picture-format.ts';

export function damaged(format: PictureFileFormat): RangeError {
  return new RangeError(`The ${format} file is damaged. Send the complete file.`);
}

/**
 * @param what after "The JPEG file"
 * @param remedy what to do instead, without a full stop
 */
export function unsupported(format: PictureFileFormat, what: string, remedy: string): RangeError {
  return new RangeError(`The ${format} file ${what}, which is not supported. ${remedy}.`);
}
