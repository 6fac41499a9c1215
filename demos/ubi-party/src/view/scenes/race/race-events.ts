import type { Cart, RaceState, Seat } from '../../../sim/index.ts';

/** An event of the race. */
export type RaceEvent = {
  readonly type: 'hit' | 'boost' | 'jump' | 'lift' | 'finish';
  readonly seat: Seat;
};

/** Copy of the compared values of a state, which the game changes in place. */
export interface RaceGlance {
  readonly step: number;
  readonly carts: ReadonlyMap<
    Seat,
    Pick<Cart, 'hitAt' | 'boostSteps' | 'jumpSteps' | 'liftSteps' | 'finishedAt'>
  >;
}

export function glanceAtRace(state: RaceState): RaceGlance {
  return {
    step: state.step,
    carts: new Map(
      state.carts.map(({ seat, hitAt, boostSteps, jumpSteps, liftSteps, finishedAt }) => [
        seat,
        { hitAt, boostSteps, jumpSteps, liftSteps, finishedAt },
      ]),
    ),
  };
}

/** Events between two states of a round; none when the second is of an earlier time, as in a replay. */
export function raceEvents(before: RaceGlance, state: RaceState): RaceEvent[] {
  if (state.step < before.step) return [];
  return state.carts.flatMap((cart) => {
    const known = before.carts.get(cart.seat);
    if (!known) return [];
    const { seat } = cart;
    const events: RaceEvent[] = [];
    if (cart.liftSteps > known.liftSteps) events.push({ type: 'lift', seat });
    // Leaving the track counts as a hit in the rules, for the phone
    else if (cart.hitAt > known.hitAt) events.push({ type: 'hit', seat });
    if (cart.boostSteps > 0 && known.boostSteps === 0) events.push({ type: 'boost', seat });
    if (cart.jumpSteps > known.jumpSteps) events.push({ type: 'jump', seat });
    if (cart.finishedAt !== undefined && known.finishedAt === undefined)
      events.push({ type: 'finish', seat });
    return events;
  });
}

/** The leading seat: the earliest at the finish, else the one furthest along. */
export function leaderOf({ carts }: RaceState): Seat | undefined {
  let best: Cart | undefined;
  for (const cart of carts) if (!best || isBefore(cart, best)) best = cart;
  return best?.seat;
}

function isBefore(a: Cart, b: Cart): boolean {
  if (a.finishedAt !== undefined || b.finishedAt !== undefined)
    return (a.finishedAt ?? Infinity) < (b.finishedAt ?? Infinity);
  return a.distance > b.distance;
}
