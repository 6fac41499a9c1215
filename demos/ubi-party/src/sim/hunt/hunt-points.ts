import { placesByScore, type Places, type Seat } from '../game.ts';
import type { Hunt, HuntGain, HuntState } from './hunt-state.ts';

const BY_PLACE = [3, 2] as const;
const LATER = 1;
const OF_BEST_SCORE = 1;

/** Points of a place, from 1, without the one of the best score. */
export const pointsOfPlace = (place: number): number => BY_PLACE[place - 1] ?? LATER;

/** The players who have found the thing, the earliest shutter first. */
export function findersOf({ photos, hunters }: Hunt): readonly Seat[] {
  return hunters
    .filter((seat) => photos[seat]?.verdict === 'found')
    .sort((a, b) => photos[a]!.atMs - photos[b]!.atMs || a - b);
}

/** Points that the players get for the thing in the present state. Of equal best scores the earlier one counts. */
export function gainsOf(hunt: Hunt): Record<Seat, HuntGain> {
  const finders = findersOf(hunt);
  const scoreOf = (seat: Seat): number => hunt.photos[seat]!.score;
  const best = finders.reduce<Seat | undefined>(
    (one, seat) => (one === undefined || scoreOf(seat) > scoreOf(one) ? seat : one),
    undefined,
  );
  return Object.fromEntries(
    finders.map((seat, index) => {
      const isBest = seat === best;
      const points = pointsOfPlace(index + 1) + (isBest ? OF_BEST_SCORE : 0);
      return [seat, { place: index + 1, points, isBest }];
    }),
  );
}

export function placesOf({ seats, points }: HuntState): Places {
  return placesByScore(seats, (seat) => points[seat] ?? 0);
}

/** `1st`, `2nd`, `11th`, `23rd`. */
export function ordinal(place: number): string {
  const isTeen = place % 100 >= 11 && place % 100 <= 13;
  return `${place}${(isTeen ? undefined : ['th', 'st', 'nd', 'rd'][place % 10]) ?? 'th'}`;
}
