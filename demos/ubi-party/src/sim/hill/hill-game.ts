import { counted } from '@ubii/words';

import {
  placeOf,
  AT_REST,
  STEPS_PER_SECOND,
  placesByScore,
  NEWS_STEPS,
  type Feedback,
  type Controls,
  type Seat,
  type Places,
  type Game,
  type Hud,
} from '../game.ts';
import { length, unit } from '../plane/plane.ts';
import {
  standing,
  nextRing,
  SUDDEN_DEATH_AT,
  startHill,
  LONGEST,
  type HillState,
  type Piece,
} from './hill-state.ts';
import { stepHill, type HillSettings } from './step-hill.ts';

/** Seeks the middle, and dashes at who stands between it and the edge. */
function hillBot(state: HillState, seat: Seat): Controls {
  const own = state.pieces.find((piece) => piece.seat === seat);
  if (!own || own.outAt !== undefined) return AT_REST;
  const target = victim(state, own);
  const atEdge = length(own.position) > state.radius * 0.7;
  const goal = atEdge || !target ? { x: 0, y: 0 } : target.position;
  // Predicted position: on ice one steers against one's own speed
  const ahead = {
    x: goal.x - own.position.x - own.velocity.x * 0.5,
    y: goal.y - own.position.y - own.velocity.y * 0.5,
  };
  const { x, y } = unit(ahead, { x: 0, y: 0 });
  const isNear = target !== undefined && distance(own, target) < 4;
  return { x, y, isPressed: !atEdge && isNear && own.charge < 0.7 };
}

/** The nearest piece among those further out. */
function victim(state: HillState, own: Piece): Piece | undefined {
  return standing(state)
    .filter((piece) => piece !== own && length(piece.position) >= length(own.position))
    .sort((a, b) => distance(own, a) - distance(own, b) || a.seat - b.seat)[0];
}

function distance(a: Piece, b: Piece): number {
  return length({ x: a.position.x - b.position.x, y: a.position.y - b.position.y });
}

/** Seconds with the crown that fill the ring on the phone. */
const FULL_RING_S = 20;

function hillFeedback(state: HillState, seat: Seat, places: Places): Feedback {
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

/** A ring that falls is counted down from here, seconds. */
const COUNTED_FROM_S = 3;

function hillHud(state: HillState, nameOf: (seat: Seat) => string): Hud {
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

/** Bonus for the last one standing, in steps with the crown. */
const LAST_STANDING = 20 * STEPS_PER_SECOND;

/** King of the Hill: a slippery platform that loses its rings. The time with the crown is the score. */
export const hillGame: Game<HillState, HillSettings> = {
  id: 'hill',
  title: 'King of the Hill',
  explanation: [
    'Stand in the yellow middle to get the crown. Your time with it is your score.',
    'Hold the button to charge, let it go to dash. Push the others off.',
    'The rings fall from the outside in. The last player standing gets 20 seconds.',
  ],
  controller: { steering: 'stick', button: 'Dash', isHeld: true },
  settings: { friction: 1, speed: 1, push: 1 },
  start: startHill,
  step: stepHill,
  isOver: (state) => state.step >= LONGEST || standing(state).length <= 1,
  places,
  feedback: (state, seat) => hillFeedback(state, seat, places(state)),
  hud: hillHud,
  bot: hillBot,
};

function places(state: HillState): Places {
  return placesByScore(
    state.pieces.map(({ seat }) => seat),
    // Of equal scores, who stood longer is before the other
    (seat) => scoreOf(state, seat) * (LONGEST + 2) + stoodFor(state, seat),
  );
}

/** Steps on the platform; who stands has more than everybody who fell. */
function stoodFor(state: HillState, seat: number): number {
  return state.pieces.find((one) => one.seat === seat)!.outAt ?? LONGEST + 1;
}

/** Steps with the crown, with what the last one who stands gets. */
function scoreOf(state: HillState, seat: number): number {
  const left = standing(state);
  const isLast = left.length === 1 && left[0]!.seat === seat;
  const piece = state.pieces.find((one) => one.seat === seat)!;
  return piece.crownSteps + (isLast ? LAST_STANDING : 0);
}
