import { describe, expect, it } from 'vitest';
import type { Clock, PreciseClock } from '../clock.ts';

/** A clock with what makes its time pass: real time for a real clock, a push for a fake. */
export interface ClockSuiteWorld<C extends Clock = Clock> {
  readonly clock: C;
  readonly passTime: () => void | Promise<void>;
}

/** Tests of every clock. */
export function clockSuite(name: string, createWorld: () => ClockSuiteWorld): void {
  describe(`${name}, a Clock`, () => {
    it('tells the epoch in milliseconds', () => {
      const { clock } = createWorld();
      expect(clock.nowMs()).toBeGreaterThan(Date.UTC(2020, 0, 1));
    });

    it('goes forward by what a timer waited for', async () => {
      const world = createWorld();
      const beforeMs = world.clock.monotonicMs();
      await later(world, 20);
      // Timers of the platform count whole milliseconds and may seem one early.
      expect(world.clock.monotonicMs() - beforeMs).toBeGreaterThanOrEqual(19);
    });

    it('calls a timer once, and an interval again and again', async () => {
      const world = createWorld();
      let once = 0;
      let often = 0;
      world.clock.after(1, () => once++);
      const cancel = world.clock.every(1, () => often++);
      while (often < 3) await later(world, 5);
      cancel();
      expect(once).toBe(1);
    });

    it('does not call what was cancelled, however often it was', async () => {
      const world = createWorld();
      const called: string[] = [];
      const cancelAfter = world.clock.after(1, () => called.push('after'));
      const cancelEvery = world.clock.every(1, () => called.push('every'));
      cancelAfter();
      cancelEvery();
      cancelAfter();
      await later(world, 20);
      cancelEvery();
      expect(called).toEqual([]);
    });

    it('ends the turn after what runs now, in order', async () => {
      const { clock, passTime } = createWorld();
      const order: string[] = [];
      clock.atEndOfTurn(() => order.push('first'));
      const ended = new Promise<void>((resolve) => {
        clock.atEndOfTurn(() => {
          order.push('second');
          resolve();
        });
      });
      order.push('now');
      await passTime();
      await ended;
      expect(order).toEqual(['now', 'first', 'second']);
    });
  });
}

/** Tests of every clock that tells fractions of a millisecond. */
export function preciseClockSuite(
  name: string,
  createWorld: () => ClockSuiteWorld<PreciseClock>,
): void {
  clockSuite(name, createWorld);

  describe(`${name}, a PreciseClock`, () => {
    it('tells the same time with fractions', () => {
      const { clock } = createWorld();
      const beforeMs = clock.nowMs();
      const preciseMs = clock.preciseMs();
      expect(preciseMs).toBeGreaterThanOrEqual(beforeMs);
      expect(preciseMs).toBeLessThan(clock.nowMs() + 1);
    });
  });
}

async function later({ clock, passTime }: ClockSuiteWorld, delayMs: number): Promise<void> {
  const due = new Promise<void>((resolve) => clock.after(delayMs, resolve));
  await passTime();
  await due;
}
