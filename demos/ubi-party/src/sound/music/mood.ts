import {
  gameOf,
  lapOf,
  trackOf,
  type HillState,
  type RaceState,
  type Room,
} from '../../sim/index.ts';
import type { Mood } from './tunes.ts';

/** The current mood of the music; undefined is silence. @param state of the round that is played */
export function moodOf(room: Room, state: unknown): Mood | undefined {
  switch (room.phase) {
    case 'lobby':
    case 'explanation':
      return { kind: 'lobby' };
    case 'countdown':
      return undefined;
    case 'play':
      return moodOfGame(gameOf(room), state);
    case 'podium':
      return { kind: 'podium', winner: room.results.at(-1)?.places[0]?.[0] ?? 0 };
    case 'end':
      return { kind: 'podium', winner: leaderOf(room) };
  }
}

/** The lowest seat of those who have the most points. */
export function leaderOf({ players }: Room): number {
  return [...players].sort((a, b) => b.points - a.points || a.seat - b.seat)[0]?.seat ?? 0;
}

function moodOfGame(game: string | undefined, state: unknown): Mood {
  if (game === 'duel' || game === 'hunt') return { kind: game };
  if (game === 'race') return { kind: game, isLastLap: state !== undefined && isLastLap(state) };
  if (game !== 'hill') return { kind: 'table' };
  const pieces = (state as HillState | undefined)?.pieces ?? [];
  const out = pieces.filter(({ outAt }) => outAt !== undefined).length;
  return { kind: game, players: pieces.length, out };
}

function isLastLap(state: unknown): boolean {
  const race = state as RaceState;
  const track = trackOf(race);
  return race.carts.some((cart) => lapOf(cart, track) === track.laps);
}
