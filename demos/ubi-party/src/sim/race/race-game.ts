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
import { clamp, cross, dot, length, unit } from '../plane/plane.ts';
import {
  trackOf,
  lapOf,
  stepsAfterFirst,
  LONGEST_RACE,
  startRace,
  type RaceState,
  type Cart,
} from './race-state.ts';
import { stepRace, type RaceSettings } from './step-race.ts';
import { placeAt } from './track.ts';

/** Looks ahead as far as it is fast, brakes before bends, and boosts where it is straight. */
function raceBot(state: RaceState, seat: Seat): Controls {
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

function raceFeedback(state: RaceState, seat: Seat, places: Places): Feedback {
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

/** Units per second: turns a distance into a time behind the leader. */
const USUAL_SPEED = 12;

function raceHud(state: RaceState, places: Places, nameOf: (seat: Seat) => string): Hud {
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

/** Marble Dash: three laps; who left the track is put back. */
export const raceGame: Game<RaceState, RaceSettings> = {
  id: 'race',
  title: 'Marble Dash',
  explanation: [
    'Steer by tilting the phone, or with your thumb. The cart drives automatically.',
    'Chevrons boost you. Press when the pad is full for a boost of your own.',
    'If you leave the track, you are put back. When the first player finishes, the others have a time limit.',
  ],
  controller: { steering: 'wheel', button: 'Boost', isHeld: false },
  settings: { speed: 1, grip: 1, gravity: 1 },
  start: startRace,
  step: stepRace,
  isOver,
  places,
  feedback: (state, seat) => raceFeedback(state, seat, places(state)),
  hud: (state, nameOf) => raceHud(state, places(state), nameOf),
  bot: raceBot,
};

function places(state: RaceState): Places {
  return placesByScore(
    state.carts.map(({ seat }) => seat),
    (seat) => scoreOf(state, seat),
  );
}

function isOver(state: RaceState): boolean {
  const { step, carts } = state;
  const finished = carts.flatMap(({ finishedAt }) => finishedAt ?? []);
  if (finished.length === carts.length || step >= LONGEST_RACE) return true;
  return finished.length > 0 && step >= Math.min(...finished) + stepsAfterFirst(state);
}

/** Carts that have finished come first, the earliest at the top; the others by the distance driven. */
function scoreOf({ carts }: RaceState, seat: number): number {
  const { finishedAt, distance } = carts.find((cart) => cart.seat === seat)!;
  return finishedAt === undefined ? distance - 1e6 : -finishedAt;
}
