import type { Sighting } from './accuracy.ts';

/** Pixels of a picture, and the file they are of. */
export interface Pixels {
  readonly file: string;
  readonly width: number;
  readonly height: number;
  readonly rgba: Uint8ClampedArray<ArrayBuffer>;
}

/** Detects objects in a picture, in a worker. */
export type Detect = (picture: Pixels) => Promise<readonly Sighting[]>;
