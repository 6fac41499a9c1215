import { MAX_PHOTO_BYTES, MAX_PHOTO_SIDE, type Photo } from '../../net/index.ts';

/** A still picture, not larger than a photo that is shown. */
export type Still = HTMLCanvasElement;

/** Source of a picture. */
export interface PictureSource {
  readonly element: CanvasImageSource;
  /** Pixels. */
  readonly width: number;
  readonly height: number;
}

export function takeStill({ element, width, height }: PictureSource): Still {
  const scale = Math.min(1, MAX_PHOTO_SIDE / Math.max(width, height));
  const canvas = document.createElement('canvas');
  canvas.width = Math.max(1, Math.round(width * scale));
  canvas.height = Math.max(1, Math.round(height * scale));
  contextOf(canvas).drawImage(element, 0, 0, canvas.width, canvas.height);
  return canvas;
}

export function pixelsOf(still: Still): ImageData {
  return contextOf(still).getImageData(0, 0, still.width, still.height);
}

/** The file has no Exif, so neither a location nor a device: a canvas writes none. */
export async function photoOf(still: Still, atMs: number): Promise<Photo | undefined> {
  for (const quality of [0.8, 0.6, 0.4, 0.25]) {
    const blob = await new Promise<Blob | null>((resolve) =>
      still.toBlob(resolve, 'image/jpeg', quality),
    );
    if (blob && blob.size <= MAX_PHOTO_BYTES) {
      const jpeg = new Uint8Array(await blob.arrayBuffer());
      return { jpeg, width: still.width, height: still.height, atMs };
    }
  }
  return undefined;
}

function contextOf(canvas: HTMLCanvasElement): CanvasRenderingContext2D {
  return canvas.getContext('2d', { willReadFrequently: true })!;
}
