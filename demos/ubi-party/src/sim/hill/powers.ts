import { AT_REST, STEPS_PER_SECOND, type Controls, type ReadControls } from '../game.ts';
import { length } from '../plane/vector.ts';
import { drawFraction, drawInteger } from '../random.ts';
import {
  OFFER_RADIUS,
  POWERS,
  onUnitCircle,
  standing,
  type HillState,
  type Power,
} from './hill-state.ts';

const EVERY = 8 * STEPS_PER_SECOND;
const LASTS = 5 * STEPS_PER_SECOND;

/** Lays out the next power when it is time, and gives it to the first who is there. */
export function stepPowers(state: HillState, controls: ReadControls): void {
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
