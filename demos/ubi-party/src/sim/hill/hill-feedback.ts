import { placeOf, type Feedback } from '../feedback.ts';
import { STEPS_PER_SECOND, type Places, type Seat } from '../game.ts';
import { standing, type HillState, type Piece } from './hill-state.ts';
import { nextRing } from './rings.ts';

/** Seconds with the crown that fill the ring on the phone. */
const FULL_RING_S = 20;

export function hillFeedback(state: HillState, seat: Seat, places: Places): Feedback {
  const piece = state.pieces.find((one) => one.seat === seat);
  const isOut = piece?.outAt !== undefined;
  const isKing = state.crown === seat;
  const crownS = Math.floor((piece?.crownSteps ?? 0) / STEPS_PER_SECOND);
  return {
    place: placeOf(places, seat),
    of: state.pieces.length,
    headline: isOut ? 'You’re out' : isKing ? 'You’re king' : `${standing(state).length} standing`,
    sentence: sentenceFor(state, piece, isKing, crownS),
    progress: Math.min(1, crownS / FULL_RING_S),
    gauge: piece?.charge ?? 0,
    isReady: piece !== undefined && !isOut && state.step >= piece.dashReadyAt,
    isOut,
    hitAt: Math.max(piece?.lastPush?.at ?? 0, piece?.outAt ?? 0),
  };
}

function sentenceFor(
  state: HillState,
  piece: Piece | undefined,
  isKing: boolean,
  crownS: number,
): string {
  if (!piece || piece.outAt !== undefined)
    return 'Vote for the next power: left spring, up anchor, right feather.';
  const next = nextRing(state.step);
  if (next && next.inS <= 3) return `The outer ring falls in ${Math.ceil(next.inS)}.`;
  if (piece.power) return POWER_SENTENCES[piece.power.kind];
  if (isKing) return `${crownS} s with the crown. Stay in the middle.`;
  return state.crown === undefined
    ? 'Get the crown in the yellow middle.'
    : 'Push the king out of the middle.';
}

const POWER_SENTENCES = {
  spring: 'Spring: you push harder.',
  anchor: 'Anchor: you are hard to push.',
  feather: 'Feather: you are faster.',
} as const;
