import { placeOf, type Feedback } from '../feedback.ts';
import type { Places, Seat } from '../game.ts';
import { lapOf, trackOf, type Cart, type RaceState } from './race-state.ts';

export function raceFeedback(state: RaceState, seat: Seat, places: Places): Feedback {
  const cart = state.carts.find((one) => one.seat === seat);
  const track = trackOf(state);
  const place = placeOf(places, seat);
  const whole = track.laps * track.length;
  return {
    place,
    of: state.carts.length,
    headline: headlineFor(cart, place, lapOf(cart ?? NO_CART, track), track.laps),
    sentence: sentenceFor(cart),
    progress: Math.min(1, Math.max(0, (cart?.distance ?? 0) / whole)),
    gauge: cart?.energy ?? 0,
    isReady: cart?.energy === 1 && cart.finishedAt === undefined,
    isOut: cart?.finishedAt !== undefined,
    hitAt: cart?.hitAt ?? 0,
  };
}

const NO_CART = { distance: 0 };

function headlineFor(cart: Cart | undefined, place: number, lap: number, laps: number): string {
  if (cart?.finishedAt !== undefined) return `Place ${place}`;
  return `Lap ${lap} of ${laps}`;
}

function sentenceFor(cart: Cart | undefined): string {
  if (!cart) return 'You drive in the next round.';
  if (cart.finishedAt !== undefined) return 'You have finished. Cheer for the others.';
  if (cart.liftSteps > 0) return 'Off the track: you are put back.';
  if (cart.boostSteps > 0) return 'Boost!';
  return cart.energy < 1 ? 'The boost fills up.' : 'Your boost is ready.';
}
