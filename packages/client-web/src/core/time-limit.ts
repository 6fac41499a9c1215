import type { Clock } from './ports/clock.ts';

/**
 * Waits for a promise, but not longer than said.
 * @param handleTimeout may throw; when it does not, the wait is simply over
 */
export async function within(
  clock: Clock,
  timeoutMs: number,
  promise: Promise<void>,
  handleTimeout: () => void = () => undefined,
): Promise<void> {
  let cancel = (): void => undefined;
  const timeout = new Promise<void>((resolve) => {
    cancel = clock.after(timeoutMs, resolve);
  }).then(handleTimeout);
  try {
    await Promise.race([promise, timeout]);
  } finally {
    cancel();
  }
}
