import { STEPS_PER_SECOND, withPace, type RoundSetup, type Seat, type WithPace } from '../game.ts';
import type { Vector } from '../plane/plane.ts';
import { placeAt, TRACKS, type Track } from './track.ts';

export interface Cart {
  readonly seat: Seat;
  readonly position: Vector;
  readonly velocity: Vector;
  /** Direction, unit vector. */
  heading: Vector;
  /** Along the middle line since the start, units; before the start line it is negative. */
  distance: number;
  /** To the left of the middle line, units. */
  toLeft: number;
  /** Charge of the boost, 0 to 1; at 1 the button triggers it. */
  energy: number;
  /** Whether the button was down in the step before. */
  wasPressed: boolean;
  /** Steps that are left of a boost, of a jump, and until it stands on the track again. */
  boostSteps: number;
  jumpSteps: number;
  liftSteps: number;
  /** The step of the newest hit by another cart, or of leaving the track; 0 for none. */
  hitAt: number;
  /** Steps from the start to the finish, with the fraction of the last one. */
  finishedAt?: number;
}

export interface RaceState extends WithPace {
  /** Steps since the start. */
  step: number;
  /** One of `TRACKS`. */
  readonly track: string;
  readonly carts: Cart[];
}

/** Units. */
const ROW = 2.6;
const COLUMN = 1.5;

/** Two columns before the start line; the seed says who stands where, and on which track. */
export function startRace(setup: RoundSetup): RaceState {
  const { seats, seed } = setup;
  const track = TRACKS[Math.abs(seed) % TRACKS.length]!;
  const first = Math.floor(Math.abs(seed) / TRACKS.length) % Math.max(1, seats.length);
  return {
    ...withPace(setup),
    step: 0,
    track: track.id,
    carts: seats.map((seat, index) =>
      cartAt(seat, track, (index + seats.length - first) % seats.length),
    ),
  };
}

function cartAt(seat: Seat, track: Track, slot: number): Cart {
  const distance = -(Math.floor(slot / 2) + 1) * ROW;
  const toLeft = slot % 2 === 0 ? COLUMN : -COLUMN;
  const { position, direction } = placeAt(track, distance);
  return {
    seat,
    position: { x: position.x - direction.y * toLeft, y: position.y + direction.x * toLeft },
    velocity: { x: 0, y: 0 },
    heading: { ...direction },
    distance,
    toLeft,
    energy: 0.5,
    wasPressed: false,
    boostSteps: 0,
    jumpSteps: 0,
    liftSteps: 0,
    hitAt: 0,
  };
}

export function trackOf(state: RaceState): Track {
  return TRACKS.find(({ id }) => id === state.track)!;
}

/** After the first has finished, the others have so long. */
export const stepsAfterFirst = ({ pace = 1 }: WithPace): number => 20 * STEPS_PER_SECOND * pace;
/** A race ends then, whatever happened. */
export const LONGEST_RACE = 240 * STEPS_PER_SECOND;

/** The lap a cart is in, from 1. */
export function lapOf(cart: Pick<Cart, 'distance'>, track: Track): number {
  return Math.min(track.laps, Math.max(1, Math.floor(cart.distance / track.length) + 1));
}
