import { placeOf } from '../../sim/feedback.ts';
import { playersOf, teamOf, type Player, type Room } from '../../sim/index.ts';

export interface TableRow {
  readonly player: Player;
  /** From 1; equal points share a place. */
  readonly place: number;
  /** Points of the newest round; undefined: did not play it. */
  readonly won: number | undefined;
  /** From 0; undefined: each plays alone. */
  readonly team: number | undefined;
}

/** The tournament's table, the best first. */
export function placeTable(room: Room): readonly TableRow[] {
  const last = room.results.at(-1);
  const rows = room.players.map((player) => ({
    player,
    place: 1 + room.players.filter(({ points }) => points > player.points).length,
    won: last?.points[player.seat],
    team: teamOf(room, player.seat),
  }));
  return rows.sort((a, b) => a.place - b.place || a.player.seat - b.player.seat);
}

/** The place of a seat in the newest round; undefined: did not play it. */
export function lastPlaceOf(room: Room, seat: number): number | undefined {
  const places = room.results.at(-1)?.places;
  return places?.some((seats) => seats.includes(seat)) ? placeOf(places, seat) : undefined;
}

/** The number of ready players among those who are asked, such as `3 of 5 ready`. */
export function readiness(room: Room): string {
  const asked = playersOf(room).filter(({ awaySinceMs }) => awaySinceMs === undefined);
  return `${asked.filter(({ isReady }) => isReady).length} of ${asked.length} ready`;
}

export { ordinal } from '../../sim/index.ts';
