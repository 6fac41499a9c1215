import type { Area, GameSettings, Seat, WithPace } from '../game.ts';
import { STEPS_PER_SECOND } from '../game.ts';
import type { WithRandom } from '../random.ts';
import { THINGS, type ThingId } from './things.ts';

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
