export { pictureFormatOf, type PictureFileFormat } from './picture-format.ts';
export { readPictureFile, type PictureFile } from './picture-file.ts';
export type { PictureHead } from './picture-head.ts';
export { checkSize, MAX_CHOSEN_PIXELS, MAX_PIXELS, MAX_SIDE, sizeProblem } from './size-limits.ts';
