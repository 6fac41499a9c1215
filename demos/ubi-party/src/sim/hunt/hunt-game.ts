import { counted } from '@ubii/words';

import {
  placeOf,
  AT_REST,
  withPace,
  NEWS_STEPS,
  type Feedback,
  type Question,
  type Answer,
  type Controls,
  type Seat,
  type Game,
  type Hud,
} from '../game.ts';
import { randomState } from '../random.ts';
import {
  nowMsOf,
  findersOf,
  gainsOf,
  ordinal,
  placesOf,
  pointsOfPlace,
  THINGS_A_ROUND,
  WRONG_COSTS_MS,
  thingOf,
  FIRST_SETTINGS,
  THINGS,
  type HuntState,
  type Hunt,
  type HuntPhoto,
  type HuntSettings,
} from './hunt-state.ts';
import { stepHunt } from './step-hunt.ts';

/** So long a bot looks at its photo, milliseconds. */
const LOOKS_MS = 700;

/** Finds each thing after another while, and takes a wrong photo first now and then. */
function huntBot(state: HuntState, seat: Seat): Controls {
  const { hunt, hunted } = state;
  if (!hunt) return AT_REST;
  const nowMs = nowMsOf(state);
  const count = hunted.length;
  const share = 0.2 + ((seat * 37 + count * 61) % 97) / 125;
  const findsAtMs = hunt.beganAtMs + share * (hunt.endsAtMs - hunt.beganAtMs);
  const errsAtMs = findsAtMs - 3000;
  const score = 0.55 + ((seat * 13 + count * 29) % 40) / 100;
  const isErring = (seat + count) % 3 === 0 && errsAtMs > hunt.beganAtMs;
  if (nowMs >= findsAtMs) return answering(nowMs, { text: hunt.label, score, atMs: findsAtMs });
  if (isErring && nowMs >= errsAtMs)
    return answering(nowMs, { text: 'person', score, atMs: errsAtMs });
  return AT_REST;
}

function answering(nowMs: number, answer: Answer): Controls {
  const text = nowMs < answer.atMs + LOOKS_MS ? '' : answer.text;
  return { ...AT_REST, answer: { ...answer, text } };
}

function huntHeadline({ hunt }: HuntState): string {
  return hunt ? `Find ${thingOf(hunt.label).name}` : 'Photo Hunt';
}

function huntFeedback(state: HuntState, seat: Seat): Feedback {
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

function huntHud(state: HuntState, nameOf: (seat: Seat) => string): Hud {
  const { hunt, decided, points, seats } = state;
  const nowMs = nowMsOf(state);
  const notes = Object.fromEntries(
    seats.map((seat) => [seat, counted(points[seat] ?? 0, 'point')]),
  );
  const last = hunt && findersOf(hunt).at(-1);
  const sinceMs = last === undefined ? Infinity : nowMs - hunt!.photos[last]!.atMs;
  const isNew = last !== undefined && !decided && sinceMs < (NEWS_STEPS * 1000) / 60;
  const leftS = hunt ? Math.ceil(Math.max(0, hunt.endsAtMs - nowMs) / 1000) : 0;
  return {
    headline: huntHeadline(state),
    notes,
    out: hunt ? seats.filter((seat) => !hunt.hunters.includes(seat)) : [],
    ...(hunt && !decided && { corner: { value: String(leftS), label: 'seconds to find it' } }),
    ...(isNew && {
      news: {
        seat: last,
        sentence: `${nameOf(last)} finds it as ${ordinal(findersOf(hunt!).length)}`,
      },
    }),
  };
}

/** Find a real thing and take a photo of it. Phones look at their photos themselves. */
export const huntGame: Game<HuntState, HuntSettings> = {
  id: 'hunt',
  title: 'Photo Hunt',
  explanation: [
    'Find the thing on the screen and take a photo of it. Five things.',
    'The first gets 3 points, the second 2, others 1, and the best photo 1 more.',
    'Your phone checks the photo. Nobody sees it unless you show it.',
  ],
  // Phones load the detector meanwhile, megabytes over the Wi-Fi of the room.
  explanationMs: 60_000,
  controller: { steering: 'camera', button: 'Take a photo', isHeld: false },
  settings: FIRST_SETTINGS,
  switches: Object.fromEntries(Object.entries(THINGS).map(([id, { name }]) => [id, name])),
  start: (setup) => ({
    random: randomState(setup.seed),
    ...withPace(setup),
    step: 0,
    seats: setup.seats,
    hunted: [],
    points: Object.fromEntries(setup.seats.map((seat) => [seat, 0])),
    wrongAt: {},
    isOver: false,
  }),
  step: stepHunt,
  isOver: ({ isOver }) => isOver,
  places: placesOf,
  feedback: huntFeedback,
  hud: huntHud,
  bot: huntBot,
};
