import type { Object2DList } from '@ubii/proto';

import type { Area, Question } from '../../../sim/index.ts';

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

/** The detections in the module's lists, the highest score first. */
export function sightingsOf(...lists: readonly Object2DList[]): readonly Sighting[] {
  return lists
    .flatMap(({ elements }) => elements)
    .map(({ id, pose, size, userDataJson }) => ({
      label: id,
      score: (JSON.parse(userDataJson) as { score: number }).score,
      area: {
        x: clamped(pose?.position?.x),
        y: clamped(pose?.position?.y),
        width: clamped(size?.x),
        height: clamped(size?.y),
      },
    }))
    .sort((a, b) => b.score - a.score);
}

const clamped = (value = 0): number => Math.min(1, Math.max(0, value));

/**
 * The detection that answers a question best: the wanted object if detected, else the one with the highest score;
 * undefined without detections.
 */
export function bestFor(
  { text, leastScore }: Pick<Question, 'text' | 'leastScore'>,
  sightings: readonly Sighting[],
): Sighting | undefined {
  const sure = sightings.filter(({ score }) => score >= leastScore);
  return sure.find(({ label }) => label === text) ?? sure[0];
}
