import { describe, expect, it } from 'vitest';
import { storedValue } from '../../json/read-stored.ts';
import {
  framesDue,
  GESTURE,
  gestureLine,
  lengthMs,
  MAX_FRAMES,
  MAX_LENGTH_MS,
  placeAt,
  withFrame,
  type Gesture,
  type Playing,
} from './gesture.ts';

const gesture: Gesture = {
  format: 'vector2',
  frames: [0, 100, 200, 300].map((atMs) => ({ atMs, value: { x: atMs / 100, y: 0 } })),
};
const all: Playing = { fromMs: 0, toMs: 300, speed: 1, mode: 'loop' };
const xs = (from: number | undefined, to: number, playing = all, pass = 0) =>
  framesDue(
    gesture,
    from === undefined ? undefined : { atMs: from, pass: 0 },
    { atMs: to, pass },
    playing,
  ).map(({ atMs }) => atMs);

it('is bounded in time and in number', () => {
  expect(withFrame(gesture, MAX_LENGTH_MS + 1, 0)).toBeUndefined();
  let full: Gesture = { format: 'double', frames: [] };
  for (let at = 0; at < MAX_FRAMES; at++) full = withFrame(full, at, at)!;
  expect(withFrame(full, MAX_FRAMES, 0)).toBeUndefined();
  expect(lengthMs(gesture)).toBe(300);
});

describe('placeAt', () => {
  it('ends once, begins again in a loop, and turns round in ping-pong', () => {
    expect(placeAt({ ...all, mode: 'once' }, 301)).toEqual({ atMs: 300, pass: 0, isOver: true });
    expect(placeAt(all, 350)).toEqual({ atMs: 50, pass: 1, isOver: false });
    expect(placeAt({ ...all, mode: 'ping-pong' }, 350)).toMatchObject({ atMs: 250, pass: 1 });
    expect(placeAt({ ...all, mode: 'ping-pong' }, 650)).toMatchObject({ atMs: 50, pass: 2 });
  });

  it('goes as fast as it is told, within its trimmed part', () => {
    expect(placeAt({ ...all, speed: 2 }, 100).atMs).toBe(200);
    expect(placeAt({ ...all, fromMs: 100, toMs: 200 }, 150)).toMatchObject({ atMs: 150, pass: 1 });
  });
});

describe('framesDue', () => {
  it('gives each value once, in order, forwards and backwards', () => {
    expect(xs(undefined, 0)).toEqual([0]);
    expect(xs(0, 250)).toEqual([100, 200]);
    expect(xs(250, 250)).toEqual([]);
    expect(xs(250, 50)).toEqual([200, 100]);
  });

  it('does not lose the end of a pass when the next one has begun', () => {
    expect(xs(250, 20, all, 1)).toEqual([300, 0]);
    expect(xs(250, 120, all, 1)).toEqual([300, 0, 100]);
    const turning: Playing = { ...all, mode: 'ping-pong' };
    expect(xs(250, 150, turning, 1)).toEqual([300, 200]);
  });

  it('begins a trimmed part with the value that holds there', () => {
    expect(xs(undefined, 150, { ...all, fromMs: 150 })).toEqual([100]);
    expect(xs(150, 250, { ...all, fromMs: 150, toMs: 250 })).toEqual([200]);
  });
});

it('is read from a file as from a stranger', () => {
  expect(storedValue(GESTURE, JSON.parse(JSON.stringify(gesture)))).toEqual(gesture);
  const back = [gesture.frames[1], gesture.frames[0]];
  for (const changes of [{ format: 'nonsense' }, { frames: [] }, { frames: back }]) {
    expect(storedValue(GESTURE, { ...gesture, ...changes })).toBeUndefined();
  }
  expect(gestureLine(gesture)).toEqual([0, 1, 2, 3]);
});
