import type { TopicRecord } from '@ubii/proto';
import { formatLook } from '../../../formats/families.ts';
import { isInPixels, planeShapes, type PlaneShape } from '../plane/plane-shapes.ts';
import { isKeypoint } from '../plane/skeletons.ts';

/** What one topic draws over a picture. */
export interface PictureLayer {
  readonly topic: string;
  readonly shapes: readonly PlaneShape[];
  /** Its places are in pixels, against the schema. */
  readonly pixels: boolean;
  readonly color: string;
  readonly scaleX: (x: number) => number;
  readonly scaleY: (y: number) => number;
}

/** Boxes, poses and points of some records, for an SVG with the size of the picture. */
export function pictureLayers(
  records: readonly TopicRecord[],
  { width, height }: { readonly width: number; readonly height: number },
): PictureLayer[] {
  return records.flatMap((record) => {
    const found = planeShapes(record);
    if (!found) return [];
    const pixels = isInPixels(found.shapes);
    return {
      topic: record.topic,
      shapes: found.shapes,
      pixels,
      color: found.shapes.some(isKeypoint)
        ? 'var(--family-pose)'
        : `var(--family-${formatLook(record.format).family})`,
      scaleX: (x: number) => (pixels ? x : x * width),
      scaleY: (y: number) => (pixels ? y : y * height),
    };
  });
}

/** The layers in words, for those who listen. */
export function layersInWords(layers: readonly PictureLayer[]): string {
  const names = layers.map(({ shapes }) => shapes.map(({ name }) => name || 'a place').join(', '));
  return `Drawn over the picture: ${names.join('; ')}`;
}
