/** A photo as it is shown: a JPEG file without Exif. */
export interface Photo {
  readonly jpeg: Uint8Array<ArrayBuffer>;
  /** Pixels. */
  readonly width: number;
  readonly height: number;
  /** When the shutter was pressed, whole milliseconds since the Unix epoch, master's clock. */
  readonly atMs: number;
}

/** Longest side of a photo, pixels. */
export const MAX_PHOTO_SIDE = 480;
export const MAX_PHOTO_BYTES = 60_000;

/** Photos that the host has removed from the big screen, for everybody. */
export interface HiddenPhotos {
  /** All photos, also those to come. */
  readonly all: boolean;
  /** `photoId` of single photos. */
  readonly ids: readonly string[];
}

export const photoId = (clientId: string, { atMs }: Pick<Photo, 'atMs'>): string =>
  `${clientId}@${atMs}`;

export function isHidden(hidden: HiddenPhotos | undefined, id: string): boolean {
  return hidden !== undefined && (hidden.all || hidden.ids.includes(id));
}
