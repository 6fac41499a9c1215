import { describe, expect, it } from 'vitest';
import type { Clock } from '../../core/ports/clock.ts';

/**
 * What every clock does.
 * @param createClock A clock with what makes its time pass: real time for a real clock, a push for a fake.
 */
export function clockSuite(
  name: string,
  createClock: () => { readonly clock: Clock; readonly passTime: () => void },
): void {
  const later = (
    { clock, passTime }: ReturnType<typeof createClock>,
    delayMs: number,
  ): Promise<void> =>
    new Promise((resolve) => {
      clock.after(delayMs, resolve);
      passTime();
    });

  describe(`${name}, a Clock`, () => {
    it('tells the epoch in milliseconds', () => {
      const { clock } = createClock();
      expect(clock.nowMs()).toBeGreaterThan(Date.UTC(2020, 0, 1));
    });

    it('tells the same time with fractions', () => {
      const { clock } = createClock();
      const beforeMs = clock.nowMs();
      const preciseMs = clock.preciseMs();
      expect(preciseMs).toBeGreaterThanOrEqual(beforeMs);
      expect(preciseMs).toBeLessThan(clock.nowMs() + 1);
    });

    it('goes forward by what a timer waited for', async () => {
      const parts = createClock();
      const beforeMs = parts.clock.monotonicMs();
      await later(parts, 20);
      // Timers of the platform count whole milliseconds and may seem one early.
      expect(parts.clock.monotonicMs() - beforeMs).toBeGreaterThanOrEqual(19);
    });

    it('calls a timer once, and an interval again and again', async () => {
      const parts = createClock();
      let once = 0;
      let often = 0;
      parts.clock.after(1, () => once++);
      const cancel = parts.clock.every(1, () => often++);
      while (often < 3) await later(parts, 5);
      cancel();
      expect(once).toBe(1);
    });

    it('does not call what was cancelled, however often it was', async () => {
      const parts = createClock();
      const called: string[] = [];
      const cancelAfter = parts.clock.after(1, () => called.push('after'));
      const cancelEvery = parts.clock.every(1, () => called.push('every'));
      cancelAfter();
      cancelEvery();
      cancelAfter();
      await later(parts, 20);
      cancelEvery();
      expect(called).toEqual([]);
    });

    it('ends the turn after what runs now and what was promised, in order', async () => {
      const { clock, passTime } = createClock();
      const order: string[] = [];
      await new Promise<void>((resolve) => {
        clock.atEndOfTurn(() => order.push('first'));
        clock.atEndOfTurn(() => {
          order.push('second');
          resolve();
        });
        order.push('now');
        void Promise.resolve().then(() => {
          order.push('promised');
          passTime();
        });
      });
      expect(order).toEqual(['now', 'promised', 'first', 'second']);
    });
  });
}
