import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { FrameQueue } from './frame-queue.ts';

let frames: FrameRequestCallback[] = [];
beforeEach(() => {
  frames = [];
  vi.stubGlobal('requestAnimationFrame', (frame: FrameRequestCallback) => frames.push(frame));
  vi.stubGlobal('cancelAnimationFrame', () => (frames = []));
});
afterEach(() => void vi.unstubAllGlobals());

/** Runs a frame. @returns the number of tasks done when it ends */
function draw(timeMs: number, done: readonly number[]): number {
  for (const frame of frames.splice(0)) frame(timeMs);
  return done.length;
}

function setUp(count: number) {
  const queue = new FrameQueue();
  const done: number[] = [];
  const add = (job: number): void => queue.add(() => done.push(job));
  for (let job = 0; job < count; job += 1) add(job);
  return { queue, done, add };
}

it('does more in each frame while frames are in time, and less when one is late', () => {
  const { done } = setUp(30);
  expect(done).toEqual([]);
  expect([0, 16, 33].map((timeMs) => draw(timeMs, done))).toEqual([2, 5, 9]);
  expect([83, 100].map((timeMs) => draw(timeMs, done))).toEqual([11, 14]);
  expect(done).toEqual(Array.from({ length: 14 }, (_, job) => job));
});

it('asks for no frame when all is done, and for one when more comes', () => {
  const { done, add } = setUp(1);
  expect(draw(0, done)).toBe(1);
  expect(frames).toEqual([]);
  add(1);
  expect(draw(9000, done)).toBe(2);
});

it('forgets what is cleared', () => {
  const { queue, done, add } = setUp(2);
  queue.clear();
  draw(0, done);
  expect(done).toEqual([]);
  add(2);
  draw(16, done);
  expect(done).toEqual([2]);
});
