import { STEPS_PER_SECOND, type Places, type Seat } from '../game.ts';
import { NEWS_STEPS, type Hud } from '../hud.ts';
import { lapOf, stepsAfterFirst, trackOf, type Cart, type RaceState } from './race-state.ts';

/** Units per second: turns a distance into a time behind the leader. */
const USUAL_SPEED = 12;

export function raceHud(state: RaceState, places: Places, nameOf: (seat: Seat) => string): Hud {
  const track = trackOf(state);
  const cartOf = (seat: Seat): Cart => state.carts.find((cart) => cart.seat === seat)!;
  const order = places.flat();
  const leader = cartOf(order[0]!);
  const notes = Object.fromEntries(order.map((seat) => [seat, noteFor(cartOf(seat), leader)]));
  const finished = state.carts.filter(({ finishedAt }) => finishedAt !== undefined);
  const newest = finished
    .filter(({ finishedAt }) => state.step - finishedAt! < NEWS_STEPS)
    .sort((a, b) => b.finishedAt! - a.finishedAt!)[0];
  const corner = cornerOf(state, finished);
  return {
    headline: `Lap ${lapOf(leader, track)} of ${track.laps}`,
    notes,
    out: [],
    ...(corner && { corner }),
    ...(newest && {
      news: {
        seat: newest.seat,
        sentence:
          order[0] === newest.seat
            ? `${nameOf(newest.seat)} wins`
            : `${nameOf(newest.seat)} has finished`,
      },
    }),
  };
}

function noteFor(cart: Cart, leader: Cart): string {
  if (cart.finishedAt !== undefined && cart !== leader && leader.finishedAt !== undefined)
    return `+${((cart.finishedAt - leader.finishedAt) / STEPS_PER_SECOND).toFixed(1)} s`;
  if (cart === leader) return leader.finishedAt === undefined ? 'leads' : clock(leader.finishedAt);
  return `+${(Math.max(0, leader.distance - cart.distance) / USUAL_SPEED).toFixed(1)} s`;
}

/** After the first, the others have so long. */
function cornerOf(state: RaceState, finished: readonly Cart[]): Hud['corner'] {
  if (finished.length === 0 || finished.length === state.carts.length) return undefined;
  const first = Math.min(...finished.map(({ finishedAt }) => finishedAt!));
  const left = Math.ceil((first + stepsAfterFirst(state) - state.step) / STEPS_PER_SECOND);
  return { value: String(Math.max(0, left)), label: 'seconds left' };
}

function clock(steps: number): string {
  const seconds = steps / STEPS_PER_SECOND;
  return `${Math.floor(seconds / 60)}:${(seconds % 60).toFixed(1).padStart(4, '0')}`;
}
