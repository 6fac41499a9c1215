import {
  AT_REST,
  STEPS_PER_SECOND,
  STEP_S,
  type Controls,
  type ReadControls,
  type GameSettings,
} from '../game.ts';
import { collide, length, unit, withinOne, type Disc } from '../plane/plane.ts';
import { drawFraction, drawInteger } from '../random.ts';
import {
  OFFER_RADIUS,
  POWERS,
  onUnitCircle,
  standing,
  MIDDLE_RADIUS,
  radiusAt,
  type HillState,
  type Power,
  type Piece,
} from './hill-state.ts';

const EVERY = 8 * STEPS_PER_SECOND;
const LASTS = 5 * STEPS_PER_SECOND;

/** Lays out the next power when it is time, and gives it to the first piece that reaches it. */
function stepPowers(state: HillState, controls: ReadControls): void {
  countVotes(state, controls);
  if (!state.offer && state.step >= state.nextOfferAt) layOut(state);
  if (!state.offer) return;
  for (const piece of standing(state)) {
    const { kind, position } = state.offer;
    const away = { x: piece.position.x - position.x, y: piece.position.y - position.y };
    if (length(away) > 1 + OFFER_RADIUS) continue;
    piece.power = { kind, until: state.step + LASTS };
    delete state.offer;
    state.nextOfferAt = state.step + EVERY;
    return;
  }
}

/** Vote of a fallen player by the stick: left is the spring, away the anchor, right the feather. */
function votedFor({ x, y }: Controls): Power | undefined {
  if (x < -0.5) return 'spring';
  if (x > 0.5) return 'feather';
  return y > 0.5 ? 'anchor' : undefined;
}

function countVotes(state: HillState, controls: ReadControls): void {
  const votes: Record<Power, number> = { spring: 0, anchor: 0, feather: 0 };
  for (const { seat, outAt } of state.pieces) {
    const power = votedFor(outAt === undefined ? AT_REST : controls(seat));
    if (power) votes[power] += 1;
  }
  state.votes = votes;
}

function layOut(state: HillState): void {
  const most = Math.max(...POWERS.map((power) => state.votes[power]));
  const wanted = POWERS.filter((power) => state.votes[power] === most);
  const kind = wanted[drawInteger(state, 0, wanted.length - 1)]!;
  const { x, y } = onUnitCircle(drawFraction(state));
  const radius = state.radius * (0.35 + 0.35 * drawFraction(state));
  state.offer = { kind, position: { x: x * radius, y: y * radius } };
}

/** Settings that can be changed during the game: factors of the default values. */
export interface HillSettings extends GameSettings {
  /** 0 is ice without end. */
  readonly friction: number;
  /** Factor of the top speed of pieces. */
  readonly speed: number;
  /** Factor of the speed of a pushed piece. */
  readonly push: number;
}

/** Units per second squared. */
const ACCELERATION = 9;
/** Share of the speed that is lost per second. */
const FRICTION = 1.4;
/** Units per second, for a touch of the button and added for a full charge. */
const DASH = { least: 4, charged: 7 };
const STEPS_TO_CHARGE = 0.6 * STEPS_PER_SECOND;
const STEPS_OF_DASH = 0.3 * STEPS_PER_SECOND;
const STEPS_BETWEEN_DASHES = 1.5 * STEPS_PER_SECOND;
/** A push counts for so long, when the pushed one falls. */
const PUSH_COUNTS = 2.5 * STEPS_PER_SECOND;
/** Units per second; a softer touch is no push. */
const MIN_PUSH = 1.5;

export function stepHill(state: HillState, controls: ReadControls, settings: HillSettings): void {
  state.step += 1;
  state.radius = radiusAt(state.step);
  for (const piece of standing(state)) {
    if (piece.power && piece.power.until <= state.step) delete piece.power;
    drive(piece, controls(piece.seat), state.step, settings);
  }
  push(state, settings);
  fall(state);
  crown(state);
  stepPowers(state, controls);
}

function drive(piece: Piece, controls: Controls, step: number, settings: HillSettings): void {
  const { position, velocity } = piece;
  const stick = withinOne(controls);
  const feather = piece.power?.kind === 'feather' ? 1.5 : 1;
  const gain = ACCELERATION * settings.speed * feather * STEP_S;
  velocity.x += stick.x * gain;
  velocity.y += stick.y * gain;
  dash(piece, controls, step, settings);
  const kept = 1 - Math.min(1, FRICTION * settings.friction * STEP_S);
  velocity.x *= kept;
  velocity.y *= kept;
  position.x += velocity.x * STEP_S;
  position.y += velocity.y * STEP_S;
}

/** Held, the button charges; let go, the piece dashes where its stick points. */
function dash(piece: Piece, controls: Controls, step: number, settings: HillSettings): void {
  if (controls.isPressed) {
    if (step >= piece.dashReadyAt) piece.charge = Math.min(1, piece.charge + 1 / STEPS_TO_CHARGE);
    return;
  }
  if (piece.charge === 0) return;
  const direction = unit(controls, unit(piece.velocity, { x: 0, y: 1 }));
  const gain = (DASH.least + DASH.charged * piece.charge) * settings.speed;
  piece.velocity.x += direction.x * gain;
  piece.velocity.y += direction.y * gain;
  piece.charge = 0;
  piece.dashUntil = step + STEPS_OF_DASH;
  piece.dashReadyAt = step + STEPS_BETWEEN_DASHES;
}

function push(state: HillState, settings: HillSettings): void {
  const discs = standing(state).map((piece) => asDisc(piece, state.step, settings));
  for (const { a, b, speed } of collide(discs)) {
    if (speed < MIN_PUSH) continue;
    a.piece.lastPush = { by: b.piece.seat, at: state.step };
    b.piece.lastPush = { by: a.piece.seat, at: state.step };
  }
}

function asDisc(piece: Piece, step: number, { push }: HillSettings): Disc & { piece: Piece } {
  const power = piece.power?.kind;
  const mass = (power === 'anchor' ? 4 : 1) * (piece.dashUntil > step ? 2 : 1);
  const { position, velocity } = piece;
  return {
    piece,
    position,
    velocity,
    radius: 1,
    mass,
    bounce: (power === 'spring' ? 1.8 : 0.9) * push,
  };
}

/** A piece falls when its middle is over the edge. */
function fall(state: HillState): void {
  for (const piece of standing(state)) {
    if (length(piece.position) <= state.radius) continue;
    piece.outAt = state.step;
    const { lastPush } = piece;
    if (!lastPush || state.step - lastPush.at > PUSH_COUNTS) continue;
    const pusher = state.pieces.find(({ seat }) => seat === lastPush.by);
    if (pusher) pusher.pushes += 1;
  }
}

/** The piece that was last in the middle wears it; of several, the one that wears it already, else the nearest to the centre. */
function crown(state: HillState): void {
  const there = standing(state)
    .filter(({ position }) => length(position) <= MIDDLE_RADIUS)
    .sort((a, b) => length(a.position) - length(b.position) || a.seat - b.seat);
  const wearer = state.pieces.find(({ seat }) => seat === state.crown);
  if (wearer?.outAt !== undefined) delete state.crown;
  if (there.length > 0 && !there.some(({ seat }) => seat === state.crown))
    state.crown = there[0]!.seat;
  const now = state.pieces.find(({ seat }) => seat === state.crown);
  if (now) now.crownSteps += 1;
}
