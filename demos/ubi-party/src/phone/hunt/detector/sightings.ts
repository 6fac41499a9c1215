import type { Object2DList } from '@ubii/proto';
import type { Question } from '../../../sim/index.ts';
import type { Sighting } from './detector.ts';

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
