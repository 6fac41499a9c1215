/**
 * Returns the orientation, 1 to 8, of an APP1 segment of a JPEG file; undefined without one.
 *
 * Source: Exif 2.3: "Exif\0\0", a TIFF header, and the entries of the first directory; tag 0x0112.
 */
export function readExifOrientation(
  view: DataView,
  start: number,
  end: number,
): number | undefined {
  const tiff = start + 6;
  if (end - tiff < 8 || view.getUint32(start) !== 0x45786966) return undefined;
  const isLittle = view.getUint16(tiff) === 0x4949;
  const directory = tiff + view.getUint32(tiff + 4, isLittle);
  if (directory + 2 > end) return undefined;
  const count = view.getUint16(directory, isLittle);
  for (
    let entry = directory + 2;
    entry + 12 <= end && entry < directory + 2 + count * 12;
    entry += 12
  ) {
    if (view.getUint16(entry, isLittle) !== 0x0112) continue;
    const value = view.getUint16(entry + 8, isLittle);
    return value >= 1 && value <= 8 ? value : undefined;
  }
  return undefined;
}
