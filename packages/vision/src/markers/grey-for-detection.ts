import { greyPicture } from '../image-tools/convert-picture.ts';
import { scalePicture } from '../image-tools/crop-and-scale.ts';
import type { CvMat, OpenCv } from '../opencv/open-cv.ts';
import type { Keep } from '../opencv/open-cv-runtime.ts';
import type { Picture } from '../picture.ts';
import type { PixelPoint } from './marker-pose.ts';

/**
 * Longest side of what is looked at, pixels. OpenCV's memory grows with a picture and never shrinks, and
 * a noisy one of 12 megapixels takes 1.5 s.
 */
const MAX_SEEN_SIDE = 1920;

/** The brightness of a picture as a matrix, and the way back from its places to those of the picture. */
export function greyForDetection(
  cv: OpenCv,
  keep: Keep,
  picture: Picture,
): { image: CvMat; toPicture: (point: PixelPoint) => PixelPoint } {
  const factor = Math.min(1, MAX_SEEN_SIDE / Math.max(picture.width, picture.height));
  const width = Math.max(1, Math.round(picture.width * factor));
  const height = Math.max(1, Math.round(picture.height * factor));
  const grey = greyPicture(picture);
  const { data } = factor < 1 ? scalePicture(grey, width, height) : grey;
  const image = keep(new cv.Mat(height, width, cv.CV_8UC1));
  image.data.set(data);
  const [scaleX, scaleY] = [picture.width / width, picture.height / height];
  return {
    image,
    toPicture: ({ x, y }) => ({ x: (x + 0.5) * scaleX - 0.5, y: (y + 0.5) * scaleY - 0.5 }),
  };
}
