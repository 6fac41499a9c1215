import type { Game, GameSettings, Places, Seat } from '../game.ts';

/** Factors of the times for reading and answering. */
export const PACES = { normal: 1, relaxed: 1.5, long: 2 } as const;
export type Pace = keyof typeof PACES;

/** For people. */
export const PACE_WORDS: Readonly<Record<Pace, string>> = {
  normal: 'Normal',
  relaxed: 'Relaxed ×1.5',
  long: 'Long ×2',
};

export function isPace(value: unknown): value is Pace {
  return typeof value === 'string' && Object.hasOwn(PACES, value);
}

/** Milliseconds at the normal pace. The countdown is the same at every pace: there is nothing to read. */
export const EXPLANATION_MS = 20_000;
export const COUNTDOWN_MS = 3_000;
export const PODIUM_MS = 15_000;

/**
 * Duration of a phase with something to read, milliseconds; undefined for phases without a fixed duration.
 * @param game the one that is explained
 */
export function readingMs(
  phase: string,
  pace: Pace,
  game: Pick<Game<unknown>, 'explanationMs'> | undefined,
): number | undefined {
  if (phase === 'explanation') return (game?.explanationMs ?? EXPLANATION_MS) * PACES[pace];
  return phase === 'podium' ? PODIUM_MS * PACES[pace] : undefined;
}

/** A person or a bot with a seat. */
export interface Player {
  readonly seat: Seat;
  /** The client that plays; a bot has none. The client with the key of a seat has the seat. */
  readonly key?: string;
  readonly name: string;
  readonly isReady: boolean;
  /** Since when the person is absent, milliseconds since the Unix epoch, master's clock; undefined: present. */
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

/** The state of a tournament, as plain data: a stored one continues after a reload or a restart. */
export interface Room {
  readonly phase: Phase;
  /** When the phase ends by itself, milliseconds since the Unix epoch, master's clock. */
  readonly endsAtMs?: number;
  readonly players: readonly Player[];
  /** Spectators count neither for rounds nor for readiness. */
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
  /** Settings that differ from the default of their game, by game and name. */
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

/** A room that was stored or published, perhaps by an earlier version. */
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

/** Origin of a request: the big screen, or the client of a phone by its key. */
export type Asker = 'host' | { readonly key: string };

/** An event that changes a room. */
export type RoomEvent =
  | { readonly type: 'join'; readonly key: string; readonly name: string }
  | { readonly type: 'watch'; readonly key: string; readonly name: string }
  /** Deliberate: gives the seat back at once, or watches no longer. */
  | { readonly type: 'leave'; readonly key: string }
  /** Its connection was lost, or it is there again. */
  | { readonly type: 'away' | 'back'; readonly key: string }
  /** Another phone takes over the seat, with all that belongs to it. */
  | { readonly type: 'hand-over'; readonly key: string; readonly to: string }
  | { readonly type: 'ready'; readonly key: string; readonly isReady: boolean }
  | { readonly type: 'kick' | 'lead'; readonly by: Asker; readonly seat: Seat }
  /** Removes a spectator. */
  | { readonly type: 'dismiss'; readonly by: Asker; readonly key: string }
  | { readonly type: 'lock' | 'hide-code'; readonly by: Asker; readonly on: boolean }
  | { readonly type: 'set-teams'; readonly by: Asker; readonly teams: number }
  | { readonly type: 'set-games'; readonly by: Asker; readonly games: readonly string[] }
  /** Between rounds. */
  | { readonly type: 'set-pace'; readonly by: Asker; readonly pace: Pace }
  | {
      readonly type: 'set-setting';
      readonly by: Asker;
      readonly game: string;
      readonly setting: string;
      readonly value: number;
    }
  /** Bots on free seats, until so many play. */
  | { readonly type: 'fill'; readonly by: Asker; readonly players: number }
  /** On to what comes next: the first round, the end of an explanation or of a podium, a new tournament. */
  | { readonly type: 'proceed'; readonly by: Asker }
  | { readonly type: 'round-over'; readonly places: Places }
  | { readonly type: 'time' };

/** Why an event changed nothing, a sentence for the one who asked. */
export class RoomRefusal extends Error {
  override readonly name = 'RoomRefusal';
}
