import type { TopicRecord } from '@ubii/proto';
import { formatLook } from '../../../formats/families.ts';
import { isInPixels, planeShapes, type PlaneShape } from '../plane/plane-shapes.ts';
import { isKeypoint } from '../plane/skeletons.ts';

/** Shapes of one topic over a picture. */
export interface PictureLayer {
  readonly topic: string;
  readonly shapes: readonly PlaneShape[];
  /** True when coordinates are in pixels, contrary to the schema. */
  readonly pixels: boolean;
  readonly color: string;
}

/** Converts records to layers of boxes, poses and points. */
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

/** Mirrors layers horizontally. Only positions change, so that texts stay readable. */
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

/** Text description of layers, for screen readers. */
export function layersInWords(layers: readonly PictureLayer[]): string {
  const names = layers.map(({ shapes }) => shapes.map(({ name }) => name || 'a place').join(', '));
  return `Drawn over the picture: ${names.join('; ')}`;
}
