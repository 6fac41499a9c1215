import type { RoomView } from '../net/index.ts';
import {
  isSignalled,
  RINGS,
  type Seat,
  type Hud,
  type Room,
  type DuelState,
  type HillState,
  type RaceState,
} from '../sim/index.ts';
import { leaderOf } from './tunes.ts';

/** A sound that is played once. Sounds of a seat have the pitch of its player. */
export type SoundEvent =
  | {
      readonly kind:
        | 'join'
        | 'leave'
        | 'ready'
        | 'fall'
        | 'hit'
        | 'boost'
        | 'land'
        | 'crown'
        | 'press'
        | 'news';
      readonly seat: Seat;
    }
  /** A winner. */
  | { readonly kind: 'flourish'; readonly seat: Seat }
  /** A number that counts down, and the start of a round. */
  | { readonly kind: 'count' | 'tick'; readonly left: number }
  | { readonly kind: 'go' | 'ring' | 'flag' | 'question' };

/** A countdown is played from this number. */
const COUNTED_FROM = 3;

/** Sound events of any game, derived from changes of the hud. */
export function hudEvents(before: Hud | undefined, after: Hud): SoundEvent[] {
  if (!before) return [];
  const events: SoundEvent[] = after.out
    .filter((seat) => !before.out.includes(seat))
    .map((seat) => ({ kind: 'fall', seat }));
  const { news } = after;
  const isNew = news !== undefined && news.sentence !== before.news?.sentence;
  // The fall has a sound of its own
  if (isNew && events.length === 0) events.push({ kind: 'news', seat: news.seat });
  if (after.question !== undefined && after.question.text !== before.question?.text)
    events.push({ kind: 'question' });
  return [...events, ...tickOf(before.corner, after.corner)];
}

function tickOf(before: Hud['corner'], after: Hud['corner']): SoundEvent[] {
  const left = Number(after?.value);
  if (!after || !Number.isFinite(left) || left < 1) return [];
  const isCounting = before?.label === after.label && left < Number(before.value);
  const isFirst = before?.label !== after.label && left <= COUNTED_FROM;
  return isCounting || isFirst ? [{ kind: 'tick', left }] : [];
}

/** Sound events of a change of the room. */
export function roomEvents(before: RoomView | undefined, after: RoomView): SoundEvent[] {
  if (!before) return [];
  const [was, is] = [before.room, after.room];
  const events: SoundEvent[] = [];
  for (const { seat, key, isReady } of is.players) {
    const old = was.players.find((player) => player.seat === seat);
    if (!old) events.push({ kind: 'join', seat });
    // Bots are always ready
    else if (isReady && !old.isReady && key !== undefined) events.push({ kind: 'ready', seat });
  }
  for (const { seat } of was.players)
    if (!is.players.some((player) => player.seat === seat)) events.push({ kind: 'leave', seat });
  return is.phase === was.phase ? events : [...events, ...phaseEvents(is)];
}

function phaseEvents(room: Room): SoundEvent[] {
  switch (room.phase) {
    case 'play':
      return [{ kind: 'go' }];
    case 'podium':
      return (room.results.at(-1)?.places[0] ?? [])
        .slice(0, 3)
        .map((seat) => ({ kind: 'flourish', seat }));
    case 'end':
      return [{ kind: 'flourish', seat: leaderOf(room) }];
    default:
      return [];
  }
}

/** The wooden block of 3, 2, 1. @param left whole seconds of a countdown; undefined: there is none */
export function countEvents(before: number | undefined, left: number | undefined): SoundEvent[] {
  return left !== undefined && left !== before && left >= 1 && left <= 3
    ? [{ kind: 'count', left }]
    : [];
}

/**
 * Sound events of a particular game between two states of one round; games without an entry have those of the hud only.
 */
export function stateEvents(game: string, before: unknown, after: unknown): SoundEvent[] {
  return Object.hasOwn(COMPARISONS, game) ? COMPARISONS[game]!(before, after) : [];
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
    // One sound for the two players that collide
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

const COMPARISONS: Readonly<Record<string, (before: unknown, after: unknown) => SoundEvent[]>> = {
  race: (before, after) => raceEvents(before as RaceState, after as RaceState),
  hill: (before, after) => hillEvents(before as HillState, after as HillState),
  duel: (before, after) => duelEvents(before as DuelState, after as DuelState),
};
