import { CHANNELS, type OwnPicture, type Picture } from '../picture.ts';

/**
 * Returns a picture upright.
 *
 * @param orientation of Exif 2.3, 4.6.4 A: where the first row and column are; 1 is upright
 */
export function orient(picture: Picture, orientation: number): OwnPicture {
  const { width, height, format } = picture;
  const from = picture.data;
  const isTurned = orientation >= 5;
  const [newWidth, newHeight] = isTurned ? [height, width] : [width, height];
  const isRightFirst = [2, 3, 7, 8].includes(orientation);
  const isBottomFirst = [3, 4, 6, 7].includes(orientation);
  const step = CHANNELS[format];
  const data = new Uint8Array(from.length);
  for (let y = 0; y < newHeight; y++) {
    for (let x = 0; x < newWidth; x++) {
      const [column, row] = isTurned ? [y, x] : [x, y];
      const fromX = isRightFirst ? width - 1 - column : column;
      const fromY = isBottomFirst ? height - 1 - row : row;
      const at = (fromY * width + fromX) * step;
      const to = (y * newWidth + x) * step;
      for (let channel = 0; channel < step; channel++) data[to + channel] = from[at + channel]!;
    }
  }
  return { width: newWidth, height: newHeight, format, data };
}
