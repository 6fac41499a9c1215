import type { Clock } from './clock.ts';

/**
 * Waits for work, but not longer than `timeoutMs`. What happens to it later is ignored.
 *
 * @returns false when the time was over first
 * @throws what the work rejects with, if it does so in time
 */
export function within(
  clock: Pick<Clock, 'after'>,
  timeoutMs: number,
  work: Promise<unknown>,
): Promise<boolean> {
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
