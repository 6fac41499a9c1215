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
}

/** Boxes, poses and points of some records. */
export function pictureLayers(records: readonly TopicRecord[]): PictureLayer[] {
  return records.flatMap((record) => {
    const found = planeShapes(record);
    if (!found) return [];
    return {
      topic: record.topic,
      shapes: found.shapes,
      pixels: isInPixels(found.shapes),
      color: found.shapes.some(isKeypoint)
        ? 'var(--family-pose)'
        : `var(--family-${formatLook(record.format).family})`,
    };
  });
}

/** The layers as a mirror shows them. Words stay readable: only places change. */
export function mirroredLayers(
  layers: readonly PictureLayer[],
  pictureWidth: number,
): PictureLayer[] {
  return layers.map((layer) => {
    const end = layer.pixels ? pictureWidth : 1;
    const shapes = layer.shapes.map((shape) => ({
      ...shape,
      x: end - shape.x - (shape.size?.width ?? 0),
      ...(shape.angle !== undefined && { angle: Math.PI - shape.angle }),
    }));
    return { ...layer, shapes };
  });
}

/** The layers in words, for those who listen. */
export function layersInWords(layers: readonly PictureLayer[]): string {
  const names = layers.map(({ shapes }) => shapes.map(({ name }) => name || 'a place').join(', '));
  return `Drawn over the picture: ${names.join('; ')}`;
}
