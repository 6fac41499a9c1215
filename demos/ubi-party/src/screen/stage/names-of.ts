import type { Room, Seat } from '../../sim/index.ts';

/** With more players, bots leave the room for names to people. */
const MAX_NAMED = 18;

/** The names beside the pieces: while people gather, and look for theirs. */
export function namesOf({ phase, players }: Room): ReadonlyMap<Seat, string> {
  if (phase !== 'lobby' && phase !== 'explanation') return new Map();
  const named =
    players.length > MAX_NAMED ? players.filter(({ key }) => key !== undefined) : players;
  return new Map(named.map(({ seat, name }) => [seat, name]));
}
