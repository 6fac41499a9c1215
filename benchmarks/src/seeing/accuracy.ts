import type { Box } from '@ubii/vision';

/** An object in a picture, as reported by a detector or annotated by a person. */
export interface Sighting {
  readonly class: string;
  readonly box: Box;
}

/** Share of the sightings that are right, and of the objects that were seen; both 0 to 1. */
export interface Accuracy {
  readonly precision: number;
  readonly recall: number;
}

/** Overlap from which a box has found an object, as in PASCAL VOC's evaluation. */
const MIN_OVERLAP = 0.5;

/**
 * Compares what was seen in pictures with what is in them. Each object counts once.
 *
 * @param pictures what was seen and what is there, picture by picture
 */
export function accuracyOf(
  pictures: readonly { readonly seen: readonly Sighting[]; readonly there: readonly Sighting[] }[],
): Accuracy {
  let right = 0;
  for (const { seen, there } of pictures) {
    const missing = [...there];
    for (const one of seen) {
      const index = missing.findIndex(
        (object) => object.class === one.class && overlap(object.box, one.box) >= MIN_OVERLAP,
      );
      if (index < 0) continue;
      missing.splice(index, 1);
      right += 1;
    }
  }
  const count = (of: 'seen' | 'there'): number =>
    pictures.reduce((sum, picture) => sum + picture[of].length, 0);
  return {
    precision: count('seen') === 0 ? 0 : right / count('seen'),
    recall: count('there') === 0 ? 0 : right / count('there'),
  };
}

/** Intersection over union. */
function overlap(a: Box, b: Box): number {
  const width = Math.min(a.x + a.width, b.x + b.width) - Math.max(a.x, b.x);
  const height = Math.min(a.y + a.height, b.y + b.height) - Math.max(a.y, b.y);
  const both = Math.max(0, width) * Math.max(0, height);
  return both / (a.width * a.height + b.width * b.height - both);
}
