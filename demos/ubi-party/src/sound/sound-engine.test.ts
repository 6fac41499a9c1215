import { afterEach, beforeEach, expect, test, vi } from 'vitest';

import { tuneOf } from './tunes.ts';
import { SoundEngine } from './sound-engine.ts';

/** Counts what is started; its clock stands where the test puts it. */
class FakeContext {
  state = 'suspended';
  currentTime = 0;
  sampleRate = 100;
  destination = {};
  createBuffer = () => ({ duration: 1, getChannelData: () => new Float32Array(100) });
  resume = vi.fn(async () => void (this.state = 'running'));
  suspend = vi.fn(async () => void (this.state = 'suspended'));
  close = vi.fn(async () => undefined);
}
const starts: number[] = [];
const param = () => ({
  value: 0,
  setValueAtTime: () => undefined,
  linearRampToValueAtTime: () => undefined,
  exponentialRampToValueAtTime: () => undefined,
});
class FakeNode {
  readonly gain = param();
  readonly frequency = param();
  readonly context: unknown;
  constructor(context: unknown) {
    this.context = context;
  }
  connect = (to: unknown): unknown => to;
  stop = (): void => undefined;
  start = (atS: number): void => void starts.push(atS);
}

let context: FakeContext;
let engine: SoundEngine;
const created = vi.fn(() => (context = new FakeContext()) as unknown as AudioContext);

beforeEach(() => {
  vi.useFakeTimers();
  starts.length = 0;
  created.mockClear();
  for (const node of [
    'Gain',
    'Oscillator',
    'DynamicsCompressor',
    'BiquadFilter',
    'AudioBufferSource',
  ])
    vi.stubGlobal(`${node}Node`, FakeNode);
  engine = new SoundEngine(created);
});
afterEach(() => {
  engine.close();
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

const SEEN = { isMuted: false, isMusicMuted: false, isHidden: false };

test('nothing is created before the first gesture, nor while muted', () => {
  engine.apply({ ...SEEN, isMuted: true });
  engine.play([{ kind: 'flag' }]);
  engine.start();
  expect(created).not.toHaveBeenCalled();
  engine.apply(SEEN);
  engine.start();
  engine.start();
  expect(created).toHaveBeenCalledOnce();
});

test('music is given to the clock of the sound card ahead of time', () => {
  engine.setTune(tuneOf({ kind: 'race', isLastLap: false }));
  engine.start();
  vi.advanceTimersByTime(60);
  expect(Math.max(...starts)).toBe(0);
  expect(starts.length).toBeGreaterThan(0);
  const before = starts.length;
  vi.advanceTimersByTime(60);
  expect(starts).toHaveLength(before);
  context.currentTime = 0.2;
  vi.advanceTimersByTime(60);
  expect(Math.max(...starts)).toBe(0.25);
});

test('events of one moment are heard one after the other, not more than can be distinguished', () => {
  engine.start();
  engine.play(Array.from({ length: 40 }, (_, seat) => ({ kind: 'hit', seat: seat % 32 })));
  expect(new Set(starts).size).toBe(12);
});

test('a hidden or muted page is suspended, and events are not kept for later', () => {
  engine.start();
  engine.apply({ ...SEEN, isHidden: true });
  expect(context.state).toBe('suspended');
  engine.play([{ kind: 'flag' }]);
  engine.apply(SEEN);
  expect(context.state).toBe('running');
  expect(starts).toEqual([]);
  engine.apply({ ...SEEN, isMuted: true });
  expect(context.state).toBe('suspended');
});
