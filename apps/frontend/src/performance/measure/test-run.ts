import type { Clock } from '@ubii/timing';
import type { Findings } from './findings.ts';

/** Progress of a running test. */
export interface Progress {
  /** 0 to 1. */
  readonly share: number;
  /** Current step, a few words. */
  readonly words: string;
  /** Findings so far. */
  readonly findings?: Findings | undefined;
}

/** Environment of a running test. */
export interface TestRun {
  readonly clock: Clock;
  /** Ends the test early; it returns its findings so far. */
  readonly signal: AbortSignal;
  report(progress: Progress): void;
}

/** Resolves after `ms`, or when the test is aborted. */
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

/** Resolves when `isTrue` returns true, after the timeout, or when the test is aborted. Polls every `stepMs`. */
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
