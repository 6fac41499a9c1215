import { counted } from '@ubii/words';

import type { Seat } from '../game.ts';
import { NEWS_STEPS, type Hud } from '../hud.ts';
import { huntHeadline } from './hunt-feedback.ts';
import { findersOf, ordinal } from './hunt-points.ts';
import { nowMsOf, type HuntState } from './hunt-state.ts';

export function huntHud(state: HuntState, nameOf: (seat: Seat) => string): Hud {
  const { hunt, decided, points, seats } = state;
  const nowMs = nowMsOf(state);
  const notes = Object.fromEntries(
    seats.map((seat) => [seat, counted(points[seat] ?? 0, 'point')]),
  );
  const last = hunt && findersOf(hunt).at(-1);
  const sinceMs = last === undefined ? Infinity : nowMs - hunt!.photos[last]!.atMs;
  const isNew = last !== undefined && !decided && sinceMs < (NEWS_STEPS * 1000) / 60;
  const leftS = hunt ? Math.ceil(Math.max(0, hunt.endsAtMs - nowMs) / 1000) : 0;
  return {
    headline: huntHeadline(state),
    notes,
    out: hunt ? seats.filter((seat) => !hunt.hunters.includes(seat)) : [],
    ...(hunt && !decided && { corner: { value: String(leftS), label: 'seconds to find it' } }),
    ...(isNew && {
      news: {
        seat: last,
        sentence: `${nameOf(last)} finds it as ${ordinal(findersOf(hunt!).length)}`,
      },
    }),
  };
}
