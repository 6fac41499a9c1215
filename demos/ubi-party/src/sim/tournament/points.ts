import type { Places, Seat } from '../game.ts';

/** By place; players who share a place all get its points. */
const BY_PLACE = [10, 8, 6, 5, 4, 3, 2, 1];

/** The points of a round, by seat. Everybody who played gets one at least. */
export function pointsOf(places: Places): Record<Seat, number> {
  const points: Record<Seat, number> = {};
  let place = 0;
  for (const seats of places) {
    for (const seat of seats) points[seat] = BY_PLACE[place] ?? 1;
    place += seats.length;
  }
  return points;
}
