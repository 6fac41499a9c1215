import type { Seat, Answer, Area } from '../sim/index.ts';
import type { PhoneDelay } from './round.ts';

/** For a phone without a measurement: most connections in a room are faster. */
export const UNKNOWN_DELAY: PhoneDelay = { leastMs: 0, mostMs: 100 };

/** The time that a phone sent, and the time that counts; both milliseconds since the Unix epoch. */
export interface JudgedTime {
  readonly claimedMs: number;
  readonly judgedMs: number;
}

/**
 * Returns when something happened: the time that the phone claims, within the bounds of its arrival. All times are of the
 * master's clock, milliseconds.
 *
 * @param arrivedMs when its record arrived
 * @param delay of this phone
 */
export function judgeTime(
  claimedMs: number,
  arrivedMs: number,
  { leastMs, mostMs }: PhoneDelay,
): number {
  return Math.min(arrivedMs - leastMs, Math.max(arrivedMs - mostMs, claimedMs));
}

/** Judges a new claim of a seat once: later measurements do not change the result. */
export function judgeOnce(
  judged: Record<Seat, JudgedTime>,
  seat: Seat,
  claimedMs: number,
  arrivedMs: number,
  delay: PhoneDelay = UNKNOWN_DELAY,
): { readonly judgedMs: number; readonly isNew: boolean } {
  const known = judged[seat];
  if (known?.claimedMs === claimedMs) return { judgedMs: known.judgedMs, isNew: false };
  const judgedMs = judgeTime(claimedMs, arrivedMs, delay);
  judged[seat] = { claimedMs, judgedMs };
  return { judgedMs, isNew: true };
}

/** A record of `object2D`, as it comes from the runtime; anybody who has joined may publish one. */
export interface AnswerRecord {
  readonly object2D?: {
    readonly id?: string;
    readonly pose?: { readonly position?: { readonly x?: number; readonly y?: number } };
    readonly size?: { readonly x?: number; readonly y?: number };
    readonly userDataJson?: string;
  };
}

const MAX_CHARACTERS = 30;
const MAX_JSON_CHARACTERS = 200;
/** A phone may look so long at a photo, milliseconds. */
const OLDEST_MS = 10_000;
/** Answers from further in the future are left out. */
const MAX_AHEAD_MS = 2000;

/**
 * Parses the answer of a phone; undefined for a record that is not one. Texts are lower-case words, like class names.
 *
 * @param nowMs milliseconds since the Unix epoch
 * @param startsAtMs of the round, on the same clock
 */
export function readAnswer(
  record: AnswerRecord | undefined,
  nowMs: number,
  startsAtMs: number,
): Answer | undefined {
  const object = record?.object2D;
  const text = object?.id ?? '';
  const data = readData(object?.userDataJson);
  if (!data || text.length > MAX_CHARACTERS || !/^[a-z ]*$/.test(text)) return undefined;
  const { score, atMs } = data;
  if (!(atMs <= nowMs + MAX_AHEAD_MS && atMs > nowMs - OLDEST_MS)) return undefined;
  if (!(score >= 0 && score <= 1)) return undefined;
  const area = readArea(object!);
  return { text, score, atMs: atMs - startsAtMs, ...(area && { area }) };
}

function readData(text = ''): { readonly score: number; readonly atMs: number } | undefined {
  if (text === '' || text.length > MAX_JSON_CHARACTERS) return undefined;
  try {
    const { score, atMs } = JSON.parse(text) as { score?: unknown; atMs?: unknown };
    return typeof score === 'number' && typeof atMs === 'number' ? { score, atMs } : undefined;
  } catch {
    return undefined;
  }
}

function readArea({ pose, size }: NonNullable<AnswerRecord['object2D']>): Area | undefined {
  const { x = NaN, y = NaN } = pose?.position ?? {};
  const { x: width = NaN, y: height = NaN } = size ?? {};
  const isInside = x >= 0 && y >= 0 && x + width <= 1.001 && y + height <= 1.001;
  return isInside && width > 0 && height > 0 ? { x, y, width, height } : undefined;
}
