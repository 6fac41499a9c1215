import type { Room, Seat } from '../../sim/index.ts';

/** One line of the tournament's table. */
export interface TableRow {
  readonly seat: Seat;
  readonly name: string;
  readonly place: number;
  /** Places won since the round before, negative: lost; 0 in the first round. */
  readonly moved: number;
  /** Of each round so far; undefined for one that the player did not play. */
  readonly rounds: readonly (number | undefined)[];
  readonly points: number;
  /** Won the newest round. */
  readonly isWinner: boolean;
}

/** The running table, the best first; equal points share a place, the lower seat stands first. */
export function podiumTable({ players, results }: Room): TableRow[] {
  const newest = results.at(-1);
  const winners = newest?.places[0] ?? [];
  const before = ranks(
    players.map(({ seat, points }) => ({ seat, points: points - (newest?.points[seat] ?? 0) })),
  );
  const now = ranks(players);
  return [...players]
    .sort((a, b) => b.points - a.points || a.seat - b.seat)
    .map(({ seat, name, points }) => ({
      seat,
      name,
      place: now.get(seat)!,
      moved: results.length > 1 ? before.get(seat)! - now.get(seat)! : 0,
      rounds: results.map((result) => result.points[seat]),
      points,
      isWinner: winners.includes(seat),
    }));
}

function ranks(of: readonly { readonly seat: Seat; readonly points: number }[]): Map<Seat, number> {
  return new Map(
    of.map(({ seat, points }) => [seat, 1 + of.filter((other) => other.points > points).length]),
  );
}

/** Points of the teams, the best first. */
export function teamTable({ players, teams }: Room): { readonly team: number; points: number }[] {
  return Array.from({ length: teams }, (_, team) => ({
    team,
    points: players
      .filter(({ seat }) => seat % teams === team)
      .reduce((sum, { points }) => sum + points, 0),
  })).sort((a, b) => b.points - a.points || a.team - b.team);
}
