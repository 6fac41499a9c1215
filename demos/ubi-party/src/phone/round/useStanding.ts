import { useRafFn } from '@vueuse/core';
import { shallowRef, computed, type ShallowRef, type ComputedRef } from 'vue';

import { placeOf } from '../../sim/game.ts';
import {
  GAMES,
  gameOf,
  ordinal,
  playersOf,
  teamOf,
  type Controller,
  type Room,
  type Player,
} from '../../sim/index.ts';
import { usePhone } from '../frame/phone-context.ts';

/** Description of a game, as shown on a phone. */
export interface GameTexts {
  readonly title: string;
  readonly explanation: readonly string[];
  readonly explanationMs?: number;
  readonly controller: Controller;
}

/** A game that this page does not know yet is played with everything: the host is newer than the phone. */
const UNKNOWN: GameTexts = {
  title: 'Next game',
  explanation: ['The big screen explains this game.'],
  controller: { steering: 'stick', button: 'Press', isHeld: false },
};

export function gameTexts(id: string | undefined): GameTexts {
  const games: Readonly<Record<string, GameTexts>> = GAMES;
  return (id !== undefined && Object.hasOwn(games, id) ? games[id] : undefined) ?? UNKNOWN;
}

/** The game that is played now, or next. */
export function currentGame(room: Room | undefined): GameTexts {
  return gameTexts(room && gameOf(room));
}

/** The game after the podium; undefined: it was the last. */
export function nextGame({ games, results }: Room): GameTexts | undefined {
  const id = games[results.length];
  return id === undefined ? undefined : gameTexts(id);
}

interface TableRow {
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

/** The master's clock, once per frame, milliseconds since the Unix epoch. */
export function useNow(): Readonly<ShallowRef<number>> {
  const { facts } = usePhone();
  const nowMs = shallowRef(facts.value.nowMs());
  useRafFn(() => (nowMs.value = facts.value.nowMs()));
  return nowMs;
}

/** Words of a round: 3, 2, 1 until its first step, then what the game says of this player. */
export function useStanding(game: ComputedRef<GameTexts>) {
  const { facts, room, round } = usePhone();
  const nowMs = useNow();
  const startsAtMs = computed(() => round.value?.startsAtMs ?? room.value?.endsAtMs ?? 0);
  const leftS = computed(() => Math.ceil((startsAtMs.value - nowMs.value) / 1000));
  const isStarted = computed(() => leftS.value <= 0);

  const standing = computed(() => {
    const { title, controller } = game.value;
    const { feedback } = facts.value;
    if (!isStarted.value)
      return {
        kicker: title,
        headline: String(leftS.value),
        sentence: GET_READY[controller.steering],
      };
    if (!feedback) return { kicker: title, headline: 'Go!', sentence: 'Look at the big screen.' };
    const { place, of, headline, sentence } = feedback;
    return { kicker: `${ordinal(place)} of ${of}`, headline, sentence };
  });
  return { standing, isStarted };
}

const GET_READY = {
  wheel: 'Hold the phone level.',
  stick: 'Put both thumbs on the pads.',
  none: 'Hold a thumb over the button.',
  camera: 'Get your camera ready.',
} as const;
