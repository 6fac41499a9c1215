import type { GameSettings, Places, Seat } from '../game.ts';
import type { Pace } from './pace.ts';

/** A person or a bot with a seat. */
export interface Player {
  readonly seat: Seat;
  /** The client that plays; a bot has none. Who has the key of a seat has the seat. */
  readonly key?: string;
  readonly name: string;
  readonly isReady: boolean;
  /** Milliseconds since the Unix epoch, master's clock, since when nothing is heard of them. */
  readonly awaySinceMs?: number;
  /** Came while a round was played, and plays from the next one on. */
  readonly isWaiting: boolean;
  /** Of the tournament so far. */
  readonly points: number;
}

/** A person without a seat who watches on a phone. */
export interface Spectator {
  /** The client of the phone. */
  readonly key: string;
  readonly name: string;
  /** As of a player. */
  readonly awaySinceMs?: number;
}

export const PHASES = ['lobby', 'explanation', 'countdown', 'play', 'podium', 'end'] as const;
export type Phase = (typeof PHASES)[number];

/** A round that was played, for the table. */
export interface RoundResult {
  readonly game: string;
  readonly places: Places;
  /** By seat. */
  readonly points: Readonly<Record<Seat, number>>;
}

/** All that a tournament is, as plain data: stored, it goes on after a reload or a restart. */
export interface Room {
  readonly phase: Phase;
  /** When the phase ends by itself, milliseconds since the Unix epoch, master's clock. */
  readonly endsAtMs?: number;
  readonly players: readonly Player[];
  /** They do not count: neither for rounds nor for who is ready. */
  readonly spectators: readonly Spectator[];
  /** Seat of the leading phone: the first to join, or one named by the host or the leader. */
  readonly leader?: Seat;
  readonly isLocked: boolean;
  readonly isCodeHidden: boolean;
  /** 0: each plays alone. Seats are dealt to the teams in turn. */
  readonly teams: number;
  /** The games of the tournament, in their order. */
  readonly games: readonly string[];
  readonly results: readonly RoundResult[];
  /** Settings that are not as their game is meant, by game and name. */
  readonly settings: Readonly<Record<string, GameSettings>>;
  /** Pace of reading and answering, for everybody. */
  readonly pace: Pace;
}

export const EMPTY_ROOM: Room = {
  phase: 'lobby',
  players: [],
  spectators: [],
  isLocked: false,
  isCodeHidden: false,
  teams: 0,
  games: ['race', 'hill', 'hunt'],
  results: [],
  settings: {},
  pace: 'normal',
};

/** A room as it was stored or told, perhaps by an earlier version. */
export function toRoom(room: Partial<Room>): Room {
  return { ...EMPTY_ROOM, ...room };
}

/** The game that is played now, or next. */
export function gameOf({ games, results, phase }: Room): string | undefined {
  // The result of a round stands in the list while its podium is shown
  return games[phase === 'podium' || phase === 'end' ? results.length - 1 : results.length];
}

/** Those who play the round: not who came during it. */
export function playersOf(room: Room): readonly Player[] {
  return room.players.filter(({ isWaiting }) => !isWaiting);
}

/** The team of a seat, from 0; undefined when each plays alone. */
export function teamOf({ teams }: Room, seat: Seat): number | undefined {
  return teams === 0 ? undefined : seat % teams;
}
