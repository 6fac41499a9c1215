import {
  GAMES,
  playersOf,
  type GameId,
  type Hud,
  type Room,
  type Seat,
  type Game,
} from '../sim/index.ts';
import type { RoundState } from '../modules/index.ts';
import { readJson } from './protocol.ts';

/** The round as who does not play it sees it on a phone: what the big screen says in words. */
export interface LiveRound {
  /** Of the round. */
  readonly id: string;
  readonly headline: string;
  /** The countdown. */
  readonly corner?: { readonly value: string; readonly label: string };
  /** The current question, the same for all players. */
  readonly question?: string;
  /** The best first. */
  readonly rows: readonly LiveRow[];
}

export interface LiveRow {
  readonly seat: Seat;
  /** From 1; those who are equal share it. */
  readonly place: number;
  /** Time or score. */
  readonly note: string;
  readonly isOut: boolean;
}

/** Somebody watches without playing. */
export function isWatched(room: Room): boolean {
  const isHere = ({ awaySinceMs }: { readonly awaySinceMs?: number }): boolean =>
    awaySinceMs === undefined;
  return room.spectators.some(isHere) || playersOf(room).length < room.players.length;
}

/** Undefined for an invalid state: any client that may publish can publish any value. */
export function liveRoundOf(game: GameId, state: RoundState, room: Room): LiveRound | undefined {
  const nameOf = (seat: Seat): string =>
    room.players.find((player) => player.seat === seat)?.name ?? '';
  try {
    const hud = (GAMES[game] as Game<unknown>).hud(state.state, nameOf);
    return describe(state, hud);
  } catch {
    return undefined;
  }
}

function describe({ id, places }: RoundState, hud: Hud): LiveRound {
  const rows: LiveRow[] = [];
  for (const seats of places) {
    const place = rows.length + 1;
    for (const seat of seats)
      rows.push({ seat, place, note: hud.notes[seat] ?? '', isOut: hud.out.includes(seat) });
  }
  return {
    id,
    headline: hud.headline,
    rows,
    ...(hud.corner && { corner: hud.corner }),
    ...(hud.question && { question: hud.question.text }),
  };
}

export function readLiveRound(text: string): LiveRound | undefined {
  const live = readJson<LiveRound>(text);
  const isOne = typeof live?.headline === 'string' && Array.isArray(live.rows);
  return isOne ? (live as LiveRound) : undefined;
}
