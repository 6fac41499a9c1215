import type { Area } from '../../../sim/index.ts';

/** Something that was detected. */
export interface Sighting {
  /** The class of COCO. */
  readonly label: string;
  /** 0 to 1. */
  readonly score: number;
  readonly area: Area;
}

/** Pixels as a canvas gives them: RGBA, rows from the top. */
export type Pixels = Pick<ImageData, 'width' | 'height' | 'data'>;

/** Detects things in pictures on this phone. */
export interface Detector {
  /** Pictures are looked at one after the other; the highest score first. @throws Error with a sentence */
  detect(pixels: Pixels): Promise<readonly Sighting[]>;
  close(): void;
}

/** @param onLoaded bytes that were loaded so far */
export type OpenDetector = (onLoaded: (bytes: number) => void) => Promise<Detector>;
