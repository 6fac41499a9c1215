import { isDataFormat, type DataFormat, type JsonValue } from '@ubii/proto';

/** A value at a time of a gesture. */
export interface GestureFrame {
  /** Since the gesture began, milliseconds. */
  readonly atMs: number;
  readonly value: JsonValue;
}

/** How a value changed: every change with its time, the first at 0. */
export interface Gesture {
  readonly format: DataFormat;
  readonly frames: readonly GestureFrame[];
}

/** Bounds of what is recorded, */
export const MAX_LENGTH_MS = 30_000;
export const MAX_FRAMES = 1800;
/** and of the values of one, as JSON: pictures are no gestures. */
export const MAX_VALUE_LENGTH = 4000;

export type PlayMode = 'once' | 'loop' | 'ping-pong';
export const SPEEDS = ['0.25', '0.5', '1', '2', '4'] as const;

/** How a gesture is played: which part of it, how fast, how often. */
export interface Playing {
  readonly fromMs: number;
  readonly toMs: number;
  readonly speed: number;
  readonly mode: PlayMode;
}

export function lengthMs({ frames }: Gesture): number {
  return frames.at(-1)?.atMs ?? 0;
}

/** The gesture with one more value; `undefined` when it is full. */
export function withFrame(gesture: Gesture, atMs: number, value: JsonValue): Gesture | undefined {
  if (atMs > MAX_LENGTH_MS || gesture.frames.length >= MAX_FRAMES) return undefined;
  return { ...gesture, frames: [...gesture.frames, { atMs, value }] };
}

/**
 * Where in the gesture it is after so long.
 *
 * @returns the place in milliseconds of the gesture, which pass it is, and whether that was the last one
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

/** Values sent at once at most, when a busy page comes late: the newest. */
const MAX_LATE = 50;

/** Where a gesture is while it is played. */
export interface Place {
  readonly atMs: number;
  readonly pass: number;
}

/**
 * The values that are due from one place to another, in the order they are sent; nothing before means that
 * it begins, with the value that holds there. What is left of a pass that ended is not lost.
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

/** A gesture from a file or from this browser's memory; `undefined` when it is none. */
export function readGesture(value: unknown): Gesture | undefined {
  const { format, frames } = (value ?? {}) as { format?: unknown; frames?: unknown };
  if (typeof format !== 'string' || !isDataFormat(format) || !Array.isArray(frames))
    return undefined;
  let last = 0;
  const read: GestureFrame[] = [];
  for (const frame of frames.slice(0, MAX_FRAMES)) {
    const { atMs, value: json } = (frame ?? {}) as { atMs?: unknown; value?: JsonValue };
    if (typeof atMs !== 'number' || !(atMs >= last) || atMs > MAX_LENGTH_MS || json === undefined) {
      return undefined;
    }
    last = atMs;
    read.push({ atMs, value: json });
  }
  return read.length > 0 ? { format, frames: read } : undefined;
}

/** The first number of each value, to draw the gesture with. */
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
