import type { HillState, Power, Seat } from '../../../sim/index.ts';

/** An event on the hill. */
export type HillEvent =
  | {
      readonly type: 'push';
      readonly seats: readonly [Seat, Seat];
      readonly x: number;
      readonly y: number;
    }
  | { readonly type: 'fall'; readonly seat: Seat }
  | { readonly type: 'dash'; readonly seat: Seat }
  | { readonly type: 'power'; readonly seat: Seat; readonly kind: Power }
  | { readonly type: 'crown'; readonly seat: Seat };

/** Copy of the compared values of a state, which the game changes in place. */
export interface HillGlance {
  readonly step: number;
  readonly crown: Seat | undefined;
  readonly pieces: ReadonlyMap<Seat, PieceGlance>;
}
interface PieceGlance {
  readonly pushedAt: number;
  readonly isOut: boolean;
  readonly dashUntil: number;
  readonly powerUntil: number;
}

export function glanceAtHill(state: HillState): HillGlance {
  return {
    step: state.step,
    crown: state.crown,
    pieces: new Map(
      state.pieces.map(({ seat, lastPush, outAt, dashUntil, power }) => [
        seat,
        {
          pushedAt: lastPush?.at ?? 0,
          isOut: outAt !== undefined,
          dashUntil,
          powerUntil: power?.until ?? 0,
        },
      ]),
    ),
  };
}

/** Events between two states of a round; none when the second is of an earlier time, as in a replay. */
export function hillEvents(before: HillGlance, state: HillState): HillEvent[] {
  if (state.step < before.step) return [];
  const events: HillEvent[] = [];
  for (const piece of state.pieces) {
    const { seat, lastPush, power } = piece;
    const known = before.pieces.get(seat);
    if (!known) continue;
    if (lastPush && lastPush.at > known.pushedAt && isToldBy(state, seat, lastPush)) {
      const other = state.pieces.find((one) => one.seat === lastPush.by)!;
      events.push({
        type: 'push',
        seats: [seat, other.seat],
        x: (piece.position.x + other.position.x) / 2,
        y: (piece.position.y + other.position.y) / 2,
      });
    }
    if (piece.outAt !== undefined && !known.isOut) events.push({ type: 'fall', seat });
    if (piece.dashUntil > known.dashUntil) events.push({ type: 'dash', seat });
    if (power && power.until > known.powerUntil)
      events.push({ type: 'power', seat, kind: power.kind });
  }
  if (state.crown !== undefined && state.crown !== before.crown)
    events.push({ type: 'crown', seat: state.crown });
  return events;
}

/** Both pieces of a push remember it: that of the lower seat reports it, unless the other was pushed again since. */
function isToldBy(state: HillState, seat: Seat, push: { by: Seat; at: number }): boolean {
  const other = state.pieces.find((one) => one.seat === push.by);
  if (!other) return false;
  const isMutual = other.lastPush?.by === seat && other.lastPush.at === push.at;
  return !isMutual || seat < push.by;
}
