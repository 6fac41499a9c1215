import { expect, it } from 'vitest';
import { PageClock, READING_MS, type PageFrame } from './page-clock.ts';

function setUp() {
  let now = 1_000_000;
  let next: (() => void) | undefined;
  const clock = new PageClock({
    // A clock that is read twice in a frame shows two times.
    nowMs: () => now++,
    atFrame(run) {
      next = run;
      return () => (next = undefined);
    },
  });
  return {
    clock,
    frameAfter(ms: number) {
      now += ms;
      next?.();
    },
    isRunning: () => next !== undefined,
  };
}

it('gives all views of a page one time, whenever they were added', () => {
  const { clock, frameAfter } = setUp();
  const seen: Record<string, PageFrame> = {};
  clock.follow((frame) => (seen.first = frame));
  frameAfter(16);
  frameAfter(40);
  clock.follow((frame) => (seen.added = frame));
  for (let i = 0; i < 20; i++) {
    frameAfter(16);
    expect(seen.added).toEqual(seen.first);
  }
});

it('reads numbers a few times a second, in the same frame for all views', () => {
  const { clock, frameAfter } = setUp();
  const readings: number[] = [];
  clock.follow(({ isReading, readMs }) => isReading && readings.push(readMs));
  for (let i = 0; i < 40; i++) frameAfter(25);
  expect(readings.length).toBeGreaterThan(6);
  expect(readings.length).toBeLessThan(11);
  for (let i = 1; i < readings.length; i++) {
    expect(Math.floor(readings[i]! / READING_MS)).not.toBe(
      Math.floor(readings[i - 1]! / READING_MS),
    );
  }
});

it('stops without views', () => {
  const { clock, frameAfter, isRunning } = setUp();
  const end = clock.follow(() => undefined);
  frameAfter(16);
  expect(isRunning()).toBe(true);
  end();
  expect(isRunning()).toBe(false);
});
