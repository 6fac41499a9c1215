import {
  isSignalled,
  RINGS,
  type DuelState,
  type HillState,
  type RaceState,
} from '../../sim/index.ts';
import type { SoundEvent } from './sound-event.ts';

/**
 * Sound events of a particular game between two states of one round; games without an entry have those of the hud only.
 */
export function stateEvents(game: string, before: unknown, after: unknown): SoundEvent[] {
  return Object.hasOwn(EARS, game) ? EARS[game]!(before, after) : [];
}

function raceEvents(before: RaceState, after: RaceState): SoundEvent[] {
  return after.carts.flatMap((cart): SoundEvent[] => {
    const { seat } = cart;
    const was = before.carts.find((one) => one.seat === seat);
    if (!was) return [];
    const events: SoundEvent[] = [];
    if (cart.hitAt !== was.hitAt) events.push({ kind: 'hit', seat });
    if (cart.boostSteps > 0 && was.boostSteps === 0) events.push({ kind: 'boost', seat });
    if (cart.jumpSteps === 0 && was.jumpSteps > 0) events.push({ kind: 'land', seat });
    return events;
  });
}

function hillEvents(before: HillState, after: HillState): SoundEvent[] {
  const events: SoundEvent[] = [];
  if (RINGS.some(({ fallsAt }) => before.step < fallsAt && after.step >= fallsAt))
    events.push({ kind: 'ring' });
  if (after.crown !== undefined && after.crown !== before.crown)
    events.push({ kind: 'crown', seat: after.crown });
  const hits = after.pieces.filter(({ seat, lastPush }) => {
    const was = before.pieces.find((one) => one.seat === seat);
    // Of the two who meet, one is heard
    return lastPush && lastPush.at !== was?.lastPush?.at && seat < lastPush.by;
  });
  return [...events, ...hits.map(({ seat }): SoundEvent => ({ kind: 'hit', seat }))];
}

function duelEvents(before: DuelState, after: DuelState): SoundEvent[] {
  const isSameBout = before.bout.beganAtMs === after.bout.beganAtMs;
  if (!isSameBout) return [];
  const pressed = after.seats.filter(
    (seat) => seat in after.bout.presses && !(seat in before.bout.presses),
  );
  const flag: SoundEvent[] = !isSignalled(before) && isSignalled(after) ? [{ kind: 'flag' }] : [];
  return [...flag, ...pressed.map((seat): SoundEvent => ({ kind: 'press', seat }))];
}

const EARS: Readonly<Record<string, (before: unknown, after: unknown) => SoundEvent[]>> = {
  race: (before, after) => raceEvents(before as RaceState, after as RaceState),
  hill: (before, after) => hillEvents(before as HillState, after as HillState),
  duel: (before, after) => duelEvents(before as DuelState, after as DuelState),
};
