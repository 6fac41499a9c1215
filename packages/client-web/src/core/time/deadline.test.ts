import type { Cancel } from '@ubii/timing';
import { expect, it } from 'vitest';

import { atDeadline } from './deadline.ts';

/** A clock whose timers can come late. */
class SlowClock {
  nowMs = 0;
  #timer: (() => void) | undefined;
  dueMs = 0;

  monotonicMs = (): number => this.nowMs;

  after = (delayMs: number, fn: () => void): Cancel => {
    this.dueMs = this.nowMs + delayMs;
    this.#timer = fn;
    return () => (this.#timer = undefined);
  };

  /** Lets the timer come. @param lateMs after it was due */
  fire(lateMs: number): void {
    this.nowMs = this.dueMs + lateMs;
    const timer = this.#timer;
    this.#timer = undefined;
    timer?.();
  }
}

function setup() {
  const clock = new SlowClock();
  const gaveUpMs: number[] = [];
  const cancel = atDeadline(clock, 2_000, () => gaveUpMs.push(clock.nowMs));
  return { clock, gaveUpMs, cancel };
}

it('gives up when the time is over', () => {
  const { clock, gaveUpMs } = setup();
  clock.fire(10);
  expect(gaveUpMs).toEqual([2_010]);
});

it('reads what has arrived before it gives up late', () => {
  const { clock, gaveUpMs } = setup();
  clock.fire(3_000);
  expect(gaveUpMs).toEqual([]);
  clock.fire(0);
  expect(gaveUpMs).toEqual([5_500]);
});

it('is cancelled while it reads', () => {
  const { clock, gaveUpMs, cancel } = setup();
  clock.fire(3_000);
  cancel();
  clock.fire(0);
  expect(gaveUpMs).toEqual([]);
});

it('gives up at last on a computer that is always late', () => {
  const { clock, gaveUpMs } = setup();
  for (let i = 0; i < 20; i++) clock.fire(3_000);
  expect(gaveUpMs).toHaveLength(1);
});
