import { counted } from '@ubii/words';

import { STEPS_PER_SECOND, type Seat } from '../game.ts';
import { NEWS_STEPS, type Hud } from '../hud.ts';
import type { DuelState } from './duel-state.ts';

export function duelHud(state: DuelState, headline: string, nameOf: (seat: Seat) => string): Hud {
  const { seats, decided, bout, step } = state;
  const winsOf = (seat: Seat): number => decided.filter(({ winner }) => winner === seat).length;
  const notes = Object.fromEntries(seats.map((seat) => [seat, counted(winsOf(seat), 'win')]));
  const last = decided.at(-1);
  const sinceSteps = step - (bout.beganAtMs / 1000) * STEPS_PER_SECOND;
  const isNew = last?.winner !== undefined && sinceSteps < NEWS_STEPS;
  return {
    headline,
    notes,
    out: [],
    ...(isNew && {
      news: {
        seat: last.winner!,
        sentence: `${nameOf(last.winner!)} draws after ${Math.round(last.reactionMs ?? 0)} ms`,
      },
    }),
  };
}
