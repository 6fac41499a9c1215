import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { FrameQueue } from './frame-queue.ts';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

function setUp(count: number) {
  const queue = new FrameQueue();
  const done: number[] = [];
  for (let index = 0; index < count; index += 1) queue.add(() => done.push(index));
  return { queue, done };
}

it('does a few jobs in each frame, first come first', () => {
  const { done } = setUp(10);
  expect(done).toEqual([]);
  vi.advanceTimersToNextFrame();
  expect(done).toEqual([0, 1, 2, 3]);
  vi.advanceTimersToNextFrame();
  vi.advanceTimersToNextFrame();
  expect(done).toEqual([0, 1, 2, 3, 4, 5, 6, 7, 8, 9]);
});

it('begins again when more comes, and forgets what is cleared', () => {
  const { queue, done } = setUp(1);
  vi.advanceTimersToNextFrame();
  queue.add(() => done.push(1));
  vi.advanceTimersToNextFrame();
  expect(done).toEqual([0, 1]);
  queue.add(() => done.push(2));
  queue.clear();
  vi.runAllTimers();
  expect(done).toEqual([0, 1]);
});
