import { placeOf, type Feedback, type Question } from '../feedback.ts';
import type { Seat } from '../game.ts';
import { findersOf, gainsOf, ordinal, placesOf, pointsOfPlace } from './hunt-points.ts';
import {
  nowMsOf,
  THINGS_A_ROUND,
  WRONG_COSTS_MS,
  type Hunt,
  type HuntPhoto,
  type HuntState,
} from './hunt-state.ts';
import { thingOf } from './things.ts';

export function huntHeadline({ hunt }: HuntState): string {
  return hunt ? `Find ${thingOf(hunt.label).name}` : 'Photo Hunt';
}

export function huntFeedback(state: HuntState, seat: Seat): Feedback {
  const { hunt, seats, hunted, decided } = state;
  const nowMs = nowMsOf(state);
  const isHunter = hunt?.hunters.includes(seat) ?? true;
  const photo = hunt?.photos[seat];
  const isReady = hunt !== undefined && !decided && isHunter && isOpen(photo, nowMs);
  const leftMs = hunt && !decided ? Math.max(0, hunt.endsAtMs - nowMs) : 0;
  const timeMs = hunt ? hunt.endsAtMs - hunt.beganAtMs : 1;
  return {
    place: placeOf(placesOf(state), seat),
    of: seats.length,
    headline: huntHeadline(state),
    sentence: sentenceFor(state, seat, photo),
    progress: Math.min(1, hunted.length / THINGS_A_ROUND),
    gauge: Math.min(1, leftMs / timeMs),
    isReady,
    isOut: !isHunter,
    hitAt: state.wrongAt[seat] ?? 0,
    ...(hunt && !decided && isHunter && { question: questionOf(hunt, photo) }),
  };
}

function isOpen(photo: HuntPhoto | undefined, nowMs: number): boolean {
  if (photo?.verdict === 'wrong') return nowMs >= photo.atMs + WRONG_COSTS_MS;
  return photo === undefined;
}

function questionOf(hunt: Hunt, photo: HuntPhoto | undefined): Question {
  const { label, beganAtMs, endsAtMs, leastScore } = hunt;
  const place = findersOf(hunt).length + 1;
  return {
    text: label,
    name: thingOf(label).name,
    leastScore,
    beganAtMs,
    endsAtMs,
    opensAtMs: photo?.verdict === 'wrong' ? photo.atMs + WRONG_COSTS_MS : beganAtMs,
    prize: `${ordinal(place)} would be +${pointsOfPlace(place)}`,
  };
}

function sentenceFor(state: HuntState, seat: Seat, photo: HuntPhoto | undefined): string {
  const { hunt, decided } = state;
  if (!hunt) return 'Get your camera ready.';
  if (!hunt.hunters.includes(seat)) return 'Players who share the first place hunt one more thing.';
  const { name } = thingOf(hunt.label);
  const gain = (decided?.gains ?? gainsOf(hunt))[seat];
  if (gain) {
    const best = decided && gain.isBest ? ', best photo included' : '';
    return `Found as ${ordinal(gain.place)}: +${decided ? gain.points : pointsOfPlace(gain.place)}${best}.`;
  }
  if (decided) return `You did not find ${name}. Next thing in a moment.`;
  if (photo?.verdict === 'looking') return 'Your phone checks the photo.';
  if (photo?.verdict === 'wrong') return `${whatIsSeen(photo)}, not ${name}. Try again.`;
  return `Take a photo of ${name}.`;
}

/** Detectors name classes without an article. */
function whatIsSeen({ text }: HuntPhoto): string {
  if (text === 'nothing') return 'The phone recognized nothing';
  return `The phone recognized: ${text}`;
}
