import type { Clock } from '@ubii/timing';
import type { Findings } from './findings.ts';

/** How far a running test is. */
export interface Progress {
  /** 0 to 1. */
  readonly share: number;
  /** What is done now, a few words. */
  readonly words: string;
  /** What is known so far. */
  readonly findings?: Findings | undefined;
}

/** What a test gets to run with. */
export interface TestRun {
  readonly clock: Clock;
  /** Ends the test early; it then gives what it has found so far. */
  readonly signal: AbortSignal;
  report(progress: Progress): void;
}

/** Resolves after `ms`, or when the test is ended, whichever comes first. */
export function wait(ms: number, { clock, signal }: Pick<TestRun, 'clock' | 'signal'>) {
  return new Promise<void>((resolve) => {
    if (signal.aborted) return resolve();
    const cancel = clock.after(ms, done);
    signal.addEventListener('abort', done);
    function done(): void {
      cancel();
      signal.removeEventListener('abort', done);
      resolve();
    }
  });
}

/** Resolves when `isTrue` holds, the time is up, or the test is ended. Looks every `stepMs`. */
export async function waitUntil(
  isTrue: () => boolean,
  timeoutMs: number,
  run: Pick<TestRun, 'clock' | 'signal'>,
  stepMs = 10,
): Promise<boolean> {
  const untilMs = run.clock.monotonicMs() + timeoutMs;
  while (!isTrue()) {
    if (run.signal.aborted || run.clock.monotonicMs() >= untilMs) return isTrue();
    await wait(stepMs, run);
  }
  return true;
}
