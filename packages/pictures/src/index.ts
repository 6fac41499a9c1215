export {
  pictureFormatOf,
  checkSize,
  MAX_CHOSEN_PIXELS,
  MAX_PIXELS,
  MAX_SIDE,
  sizeProblem,
  type PictureFileFormat,
  type PictureHead,
} from './picture-head.ts';
export { readPictureFile, type PictureFile } from './picture-file.ts';
