import {
  STEPS_PER_SECOND,
  placesByScore,
  type Area,
  type GameSettings,
  type Seat,
  type WithPace,
  type Places,
} from '../game.ts';
import type { WithRandom } from '../random.ts';

/** Something to find: a class of COCO that homes and schools have. */
export interface Thing {
  /** The class, as detectors name it. */
  readonly label: string;
  /** For people, behind `Find`; at most 11 characters. */
  readonly name: string;
}

/** By the name of the setting that leaves the thing out. */
export const THINGS = {
  cup: { label: 'cup', name: 'a cup' },
  bottle: { label: 'bottle', name: 'a bottle' },
  book: { label: 'book', name: 'a book' },
  chair: { label: 'chair', name: 'a chair' },
  keyboard: { label: 'keyboard', name: 'a keyboard' },
  mouse: { label: 'mouse', name: 'a PC mouse' },
  phone: { label: 'cell phone', name: 'a phone' },
  backpack: { label: 'backpack', name: 'a backpack' },
  scissors: { label: 'scissors', name: 'scissors' },
  clock: { label: 'clock', name: 'a clock' },
  spoon: { label: 'spoon', name: 'a spoon' },
  fork: { label: 'fork', name: 'a fork' },
  bowl: { label: 'bowl', name: 'a bowl' },
  banana: { label: 'banana', name: 'a banana' },
  apple: { label: 'apple', name: 'an apple' },
  laptop: { label: 'laptop', name: 'a laptop' },
  plant: { label: 'potted plant', name: 'a plant' },
  umbrella: { label: 'umbrella', name: 'an umbrella' },
  remote: { label: 'remote', name: 'a remote' },
  teddy: { label: 'teddy bear', name: 'a teddy' },
} as const satisfies Readonly<Record<string, Thing>>;
export type ThingId = keyof typeof THINGS;

const ALL: readonly Thing[] = Object.values(THINGS);

export function thingOf(label: string): Thing {
  return ALL.find((thing) => thing.label === label) ?? { label, name: `a ${label}` };
}

/** The newest photo of a player. Times are milliseconds since the start of the round. */
export interface HuntPhoto {
  /** When the shutter was pressed. */
  readonly atMs: number;
  /** The time claimed by the phone, if another. */
  readonly claimedAtMs?: number;
  /** Name of the detected object; empty while the phone is still detecting. */
  readonly text: string;
  readonly score: number;
  readonly verdict: 'looking' | 'found' | 'wrong';
  readonly area?: Area;
}

/** Points that a player got for a thing. */
export interface HuntGain {
  /** From 1, by the time of the shutter. */
  readonly place: number;
  /** With the point of the best score. */
  readonly points: number;
  readonly isBest: boolean;
}

/** The hunt for one thing. */
export interface Hunt {
  readonly label: string;
  readonly beganAtMs: number;
  endsAtMs: number;
  /** Breaks a tie: only those who lead hunt. */
  readonly isDecisive: boolean;
  readonly hunters: readonly Seat[];
  /** Hunters who are not away. */
  present: readonly Seat[];
  /** Of the photos that are right, the least score. */
  leastScore: number;
  readonly photos: Record<Seat, HuntPhoto>;
}

export interface HuntState extends WithRandom, WithPace {
  /** Steps since the start. */
  step: number;
  readonly seats: readonly Seat[];
  /** Labels, the newest last. */
  readonly hunted: string[];
  /** Undefined before the first step. */
  hunt?: Hunt;
  /** The thing is decided, and its result is shown until then. */
  decided?: { readonly untilMs: number; readonly gains: Record<Seat, HuntGain> };
  readonly points: Record<Seat, number>;
  /** The step of the newest wrong photo. */
  readonly wrongAt: Record<Seat, number>;
  isOver: boolean;
}

/** `time`: 1 is 30 s for each thing; `certainty`: 1 is a score of 0.4; and each thing: 0 leaves it out. */
export type HuntSettings = GameSettings & Readonly<Record<'time' | 'certainty' | ThingId, number>>;

export const FIRST_SETTINGS: HuntSettings = {
  time: 1,
  certainty: 1,
  ...(Object.fromEntries(Object.keys(THINGS).map((id) => [id, 1])) as Record<ThingId, number>),
};

export const THINGS_A_ROUND = 5;
/** After a wrong photo the next one counts so much later, milliseconds. */
export const WRONG_COSTS_MS = 2000;

export function nowMsOf({ step }: HuntState): number {
  return (step * 1000) / STEPS_PER_SECOND;
}

const BY_PLACE = [3, 2] as const;
const LATER = 1;
const OF_BEST_SCORE = 1;

/** Points of a place, from 1, without the one of the best score. */
export const pointsOfPlace = (place: number): number => BY_PLACE[place - 1] ?? LATER;

/** The players who have found the thing, the earliest shutter first. */
export function findersOf({ photos, hunters }: Hunt): readonly Seat[] {
  return hunters
    .filter((seat) => photos[seat]?.verdict === 'found')
    .sort((a, b) => photos[a]!.atMs - photos[b]!.atMs || a - b);
}

/** Points that the players get for the thing in the present state. Of equal best scores the earlier one counts. */
export function gainsOf(hunt: Hunt): Record<Seat, HuntGain> {
  const finders = findersOf(hunt);
  const scoreOf = (seat: Seat): number => hunt.photos[seat]!.score;
  const best = finders.reduce<Seat | undefined>(
    (one, seat) => (one === undefined || scoreOf(seat) > scoreOf(one) ? seat : one),
    undefined,
  );
  return Object.fromEntries(
    finders.map((seat, index) => {
      const isBest = seat === best;
      const points = pointsOfPlace(index + 1) + (isBest ? OF_BEST_SCORE : 0);
      return [seat, { place: index + 1, points, isBest }];
    }),
  );
}

export function placesOf({ seats, points }: HuntState): Places {
  return placesByScore(seats, (seat) => points[seat] ?? 0);
}

/** `1st`, `2nd`, `11th`, `23rd`. */
export function ordinal(place: number): string {
  const isTeen = place % 100 >= 11 && place % 100 <= 13;
  return `${place}${(isTeen ? undefined : ['th', 'st', 'nd', 'rd'][place % 10]) ?? 'th'}`;
}
