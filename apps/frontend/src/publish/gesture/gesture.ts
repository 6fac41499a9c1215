import { isDataFormat, type DataFormat, type JsonValue } from '@ubii/proto';
import * as v from 'valibot';

/** A value at a time of a gesture. */
export interface GestureFrame {
  /** Time since the start of the gesture, milliseconds. */
  readonly atMs: number;
  readonly value: JsonValue;
}

/** Recorded changes of a value with their times; the first is at 0. */
export interface Gesture {
  readonly format: DataFormat;
  readonly frames: readonly GestureFrame[];
}

/** Limits of a recording: length, number of values, */
export const MAX_LENGTH_MS = 30_000;
export const MAX_FRAMES = 1800;
/** and length of one value as JSON, which excludes images. */
export const MAX_VALUE_LENGTH = 4000;

export type PlayMode = 'once' | 'loop' | 'ping-pong';
export const SPEEDS = ['0.25', '0.5', '1', '2', '4'] as const;

/** Part, speed and repetition with which a gesture is played. */
export interface Playing {
  readonly fromMs: number;
  readonly toMs: number;
  readonly speed: number;
  readonly mode: PlayMode;
}

export function lengthMs({ frames }: Gesture): number {
  return frames.at(-1)?.atMs ?? 0;
}

/** Adds a value; returns `undefined` when the gesture is full. */
export function withFrame(gesture: Gesture, atMs: number, value: JsonValue): Gesture | undefined {
  if (atMs > MAX_LENGTH_MS || gesture.frames.length >= MAX_FRAMES) return undefined;
  return { ...gesture, frames: [...gesture.frames, { atMs, value }] };
}

/**
 * Returns the position in the gesture after the elapsed time.
 *
 * @returns position in milliseconds, number of the pass, and whether the last pass is over
 */
export function placeAt(
  { fromMs, toMs, speed, mode }: Playing,
  elapsedMs: number,
): { readonly atMs: number; readonly pass: number; readonly isOver: boolean } {
  const length = Math.max(1, toMs - fromMs);
  const gone = elapsedMs * speed;
  const pass = Math.floor(gone / length);
  if (mode === 'once' && pass > 0) return { atMs: toMs, pass: 0, isOver: true };
  const into = gone - pass * length;
  const isBack = mode === 'ping-pong' && pass % 2 === 1;
  return { atMs: isBack ? toMs - into : fromMs + into, pass, isOver: false };
}

/** Most values sent at once when the page is late; older ones are skipped. */
const MAX_LATE = 50;

/** Position in a gesture while playing. */
export interface Place {
  readonly atMs: number;
  readonly pass: number;
}

/**
 * Returns the values due between two positions, in sending order, including the rest of a pass that ended.
 * Without `before` playing starts, with the value that is valid at its first position.
 */
export function framesDue(
  { frames }: Gesture,
  before: Place | undefined,
  now: Place,
  { fromMs, toMs, mode }: Playing,
): readonly GestureFrame[] {
  const inside = frames.filter(({ atMs }) => atMs >= fromMs && atMs <= toMs);
  const between = (a: number, b: number): GestureFrame[] =>
    b >= a
      ? inside.filter(({ atMs }) => atMs > a && atMs <= b)
      : inside.filter(({ atMs }) => atMs < a && atMs >= b).reverse();
  const begin = (): GestureFrame[] => {
    const first = frames.findLast(({ atMs }) => atMs <= fromMs) ?? inside[0];
    return [...(first ? [first] : []), ...between(Math.max(fromMs, first?.atMs ?? 0), now.atMs)];
  };
  if (before === undefined) return begin().slice(-MAX_LATE);
  if (before.pass === now.pass) return between(before.atMs, now.atMs).slice(-MAX_LATE);
  const isBack = mode === 'ping-pong' && before.pass % 2 === 1;
  const turn = isBack ? fromMs : toMs;
  const rest = between(before.atMs, turn);
  const next = mode === 'ping-pong' ? between(turn, now.atMs) : begin();
  return [...rest, ...next].slice(-MAX_LATE);
}

const FRAMES = v.pipe(
  v.array(
    v.object({
      atMs: v.pipe(v.number(), v.minValue(0), v.maxValue(MAX_LENGTH_MS)),
      value: v.custom<JsonValue>((json) => json !== undefined),
    }),
  ),
  v.minLength(1),
  v.transform((frames) => frames.slice(0, MAX_FRAMES)),
  v.check((frames) => frames.every(({ atMs }, index) => atMs >= (frames[index - 1]?.atMs ?? 0))),
);

/** Schema of a gesture in a file or in the storage of the browser. */
export const GESTURE: v.GenericSchema<unknown, Gesture> = v.object({
  format: v.custom<DataFormat>((json) => typeof json === 'string' && isDataFormat(json)),
  frames: FRAMES,
});

/** Returns the first number of each value, for the sparkline. */
export function gestureLine({ frames }: Gesture): number[] {
  return frames.flatMap(({ value }) => firstNumber(value) ?? []);
}

function firstNumber(value: JsonValue): number | undefined {
  if (typeof value === 'number') return value;
  if (typeof value === 'boolean') return value ? 1 : 0;
  if (typeof value !== 'object' || value === null) return undefined;
  for (const member of Object.values(value)) {
    const found = firstNumber(member as JsonValue);
    if (found !== undefined) return found;
  }
  return undefined;
}
