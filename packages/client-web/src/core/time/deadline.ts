import type { Cancel, Clock } from '@ubii/timing';

/** A timer that comes so much too late waited for this computer, milliseconds. */
const LATE_MS = 250;
/** Time to read what has arrived meanwhile, milliseconds, and how often it is given. */
const READING_MS = 500;
const MAX_READINGS = 10;

/**
 * Calls back when something has not been answered in time. When the timer itself comes late, this computer was busy or
 * asleep and has not read what arrived meanwhile: it reads first, so that it does not give up answers that are there.
 *
 * @param waitMs time for the answer
 */
export function atDeadline(
  clock: Pick<Clock, 'after' | 'monotonicMs'>,
  waitMs: number,
  giveUp: () => void,
): Cancel {
  let readings = 0;
  const wait = (ms: number): Cancel => {
    const dueMs = clock.monotonicMs() + ms;
    return clock.after(ms, () => {
      const isLate = clock.monotonicMs() - dueMs > LATE_MS;
      if (!isLate || readings === MAX_READINGS) return giveUp();
      readings++;
      cancel = wait(READING_MS);
    });
  };
  let cancel = wait(waitMs);
  return () => cancel();
}
