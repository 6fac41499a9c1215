import { AT_REST, type Controls, type Seat } from '../game.ts';
import { clamp, cross, dot, length, unit } from '../plane/vector.ts';
import { trackOf, type RaceState } from './race-state.ts';
import { placeAt } from './track.ts';

/** Looks ahead as far as it is fast, brakes before bends, and boosts where it is straight. */
export function raceBot(state: RaceState, seat: Seat): Controls {
  const cart = state.carts.find((one) => one.seat === seat);
  if (!cart) return AT_REST;
  const track = trackOf(state);
  const speed = length(cart.velocity);
  const goal = placeAt(track, cart.distance + 3 + speed * 0.45);
  // Each on a line of its own, so that they do not drive into each other all the time
  const toLeft = ((seat % 5) - 2) * 0.25 * track.halfWidth;
  const way = unit(
    {
      x: goal.position.x - goal.direction.y * toLeft - cart.position.x,
      y: goal.position.y + goal.direction.x * toLeft - cart.position.y,
    },
    cart.heading,
  );
  const bend = dot(cart.heading, placeAt(track, cart.distance + speed * 0.9).direction);
  return {
    x: clamp(-cross(cart.heading, way) * 3, -1, 1),
    y: bend < 0.3 && speed > 9 ? -1 : 0,
    isPressed: cart.energy === 1 && bend > 0.97,
  };
}
