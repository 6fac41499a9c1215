import { counted } from '@ubii/words';

import { STEPS_PER_SECOND, type Seat } from '../game.ts';
import { NEWS_STEPS, type Hud } from '../hud.ts';
import { standing, type HillState, type Piece } from './hill-state.ts';
import { nextRing, SUDDEN_DEATH_AT } from './rings.ts';

/** A ring that falls is counted down from here, seconds. */
const COUNTED_FROM_S = 3;

export function hillHud(state: HillState, nameOf: (seat: Seat) => string): Hud {
  const notes = Object.fromEntries(
    state.pieces.map((piece) => [piece.seat, noteFor(piece, state.crown)]),
  );
  const out = state.pieces.filter(({ outAt }) => outAt !== undefined);
  const newest = out
    .filter(({ outAt }) => state.step - outAt! < NEWS_STEPS)
    .sort((a, b) => b.outAt! - a.outAt!)[0];
  const next = nextRing(state.step);
  const corner =
    next && next.inS <= COUNTED_FROM_S
      ? { value: String(Math.ceil(next.inS)), label: 'outer ring falls' }
      : undefined;
  const isSudden = state.step >= SUDDEN_DEATH_AT;
  return {
    headline: isSudden ? 'Sudden death' : `${standing(state).length} standing`,
    notes,
    out: out.map(({ seat }) => seat),
    ...(corner && { corner }),
    ...(newest && { news: { seat: newest.seat, sentence: fallOf(newest, nameOf) } }),
  };
}

function noteFor(piece: Piece, crown: Seat | undefined): string {
  if (piece.outAt !== undefined) return 'out';
  const seconds = Math.floor(piece.crownSteps / STEPS_PER_SECOND);
  if (piece.seat === crown) return `king ${seconds} s`;
  if (seconds > 0) return `${seconds} s`;
  if (piece.pushes > 0) return counted(piece.pushes, 'push', 'pushes');
  return '0 s';
}

function fallOf({ seat, lastPush, outAt }: Piece, nameOf: (seat: Seat) => string): string {
  const isPushed = lastPush !== undefined && outAt! - lastPush.at < 2.5 * STEPS_PER_SECOND;
  return isPushed ? `${nameOf(lastPush.by)} pushes ${nameOf(seat)} off` : `${nameOf(seat)} falls`;
}
