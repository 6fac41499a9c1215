import type { Clock } from '../ports/clock.ts';

/**
 * Waits for work, but not forever.
 *
 * @returns false when the time was over first
 * @throws what the work rejects with, if it does so in time
 */
export function within(clock: Clock, timeoutMs: number, work: Promise<unknown>): Promise<boolean> {
  return new Promise((resolve, reject) => {
    const cancel = clock.after(timeoutMs, () => resolve(false));
    work.then(
      () => {
        cancel();
        resolve(true);
      },
      (reason: unknown) => {
        cancel();
        reject(reason as Error);
      },
    );
  });
}
