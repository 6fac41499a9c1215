/** Properties of a picture file that are known before its pixels are decoded. */
export interface PictureHead {
  /** Pixels in a row, before the picture is turned upright. */
  readonly width: number;
  /** Rows, before the picture is turned upright. */
  readonly height: number;
  /** Exif orientation of a JPEG file, 1 (upright) to 8; 1 for other files. */
  readonly orientation: number;
  /** Length of the picture. What follows in the file does not belong to it. */
  readonly sizeBytes: number;
}
