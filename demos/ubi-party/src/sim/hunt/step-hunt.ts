import { WAIT_FOR_LATE_MS, type Controls, type ReadControls, type Seat } from '../game.ts';
import { drawInteger } from '../random.ts';
import {
  gainsOf,
  placesOf,
  nowMsOf,
  THINGS_A_ROUND,
  WRONG_COSTS_MS,
  THINGS,
  type Hunt,
  type HuntSettings,
  type HuntState,
  type ThingId,
} from './hunt-state.ts';

const TIME_MS = 30_000;
const MIN_TIME_MS = 5000;
/** A detector with a score below it is guessing (the default threshold of CenterNet). */
const MIN_SCORE = 0.4;
/** A slow phone looks so long at a photo at most. */
const WAIT_FOR_LOOKING_MS = 4000;
const SHOW_RESULT_MS = 3500;

export function stepHunt(state: HuntState, controls: ReadControls, settings: HuntSettings): void {
  state.step += 1;
  const nowMs = nowMsOf(state);
  const { hunt, decided } = state;
  if (!hunt || decided) {
    if (nowMs >= (decided?.untilMs ?? 0)) beginNext(state, nowMs, settings);
    return;
  }
  hunt.endsAtMs = hunt.beganAtMs + timeMs(state, settings);
  hunt.leastScore = Math.min(1, MIN_SCORE * settings.certainty);
  const all = hunt.hunters.map((seat) => [seat, controls(seat)] as const);
  hunt.present = all.flatMap(([seat, { isAway }]) => (isAway ? [] : seat));
  for (const [seat, control] of all) takePhoto(state, hunt, seat, control);
  if (!isDone(hunt, nowMs)) return;
  for (const seat of hunt.hunters)
    if (hunt.photos[seat]?.verdict === 'looking') delete hunt.photos[seat];
  const gains = gainsOf(hunt);
  for (const seat of hunt.hunters) state.points[seat]! += gains[seat]?.points ?? 0;
  state.decided = { untilMs: nowMs + SHOW_RESULT_MS * (state.pace ?? 1), gains };
}

/** The next thing; after the last one a decisive thing for those who share the first place, once. */
function beginNext(state: HuntState, nowMs: number, settings: HuntSettings): void {
  const count = state.hunted.length;
  const first = placesOf(state)[0] ?? [];
  const isTied = first.length > 1 && state.points[first[0]!]! > 0;
  if (count > THINGS_A_ROUND || (count === THINGS_A_ROUND && !isTied)) {
    state.isOver = true;
    return;
  }
  const isDecisive = count === THINGS_A_ROUND;
  const hunters = isDecisive ? first : state.seats;
  const label = drawThing(state, settings);
  state.hunted.push(label);
  delete state.decided;
  state.hunt = {
    label,
    beganAtMs: nowMs,
    endsAtMs: nowMs + timeMs(state, settings),
    isDecisive,
    hunters,
    present: hunters,
    leastScore: MIN_SCORE,
    photos: {},
  };
}

/** One that was not hunted yet; when all were, any that the host did not leave out. */
function drawThing(state: HuntState, settings: HuntSettings): string {
  const ids = Object.keys(THINGS) as ThingId[];
  const wanted = ids.filter((id) => settings[id] >= 0.5);
  const allowed = (wanted.length > 0 ? wanted : ids).map((id) => THINGS[id].label);
  const fresh = allowed.filter((label) => !state.hunted.includes(label));
  const from = fresh.length > 0 ? fresh : allowed;
  return from[drawInteger(state, 0, from.length - 1)]!;
}

const timeMs = ({ pace = 1 }: HuntState, { time }: HuntSettings): number =>
  Math.max(MIN_TIME_MS, TIME_MS * time) * pace;

/** The first right photo counts. A wrong one costs nothing but a short wait. */
function takePhoto(state: HuntState, hunt: Hunt, seat: Seat, { answer }: Controls): void {
  if (!answer || answer.atMs <= hunt.beganAtMs || answer.atMs > hunt.endsAtMs) return;
  const before = hunt.photos[seat];
  if (before?.verdict === 'found') return;
  if (before && answer.atMs <= before.atMs) {
    // The result of the photo that the phone was looking at
    const isResult = answer.atMs === before.atMs && before.verdict === 'looking';
    if (!isResult || answer.text === '') return;
  } else if (before?.verdict === 'wrong' && answer.atMs < before.atMs + WRONG_COSTS_MS) return;
  const { text, score, atMs, claimedAtMs, area } = answer;
  const isRight = text === hunt.label && score >= hunt.leastScore;
  const verdict = text === '' ? 'looking' : isRight ? 'found' : 'wrong';
  if (verdict === 'wrong') state.wrongAt[seat] = state.step;
  hunt.photos[seat] = {
    atMs,
    text,
    score,
    verdict,
    ...(claimedAtMs !== undefined && { claimedAtMs }),
    ...(area && { area }),
  };
}

/** All who are there have found it, or time is up and nothing can be on its way. */
function isDone({ photos, present, hunters, endsAtMs }: Hunt, nowMs: number): boolean {
  if (present.length > 0 && present.every((seat) => photos[seat]?.verdict === 'found')) return true;
  const isLooking = hunters.some((seat) => photos[seat]?.verdict === 'looking');
  return nowMs >= endsAtMs + (isLooking ? WAIT_FOR_LOOKING_MS : WAIT_FOR_LATE_MS);
}
