import type { Clock } from '@ubii/timing';

/** Both clocks of this machine at one moment, milliseconds. */
export interface ClockReading {
  /** Since an arbitrary moment; stands still while most machines sleep. */
  readonly monotonicMs: number;
  /** Since the Unix epoch; continues while the computer sleeps, and jumps when the clock is set. */
  readonly wallMs: number;
}

/** Two readings further apart than this are not of one moment: the program was interrupted between them. */
const ONE_MOMENT_MS = 2;
const ATTEMPTS = 3;

/** Reads both clocks at one moment, as far as the system lets the program run. */
export function readClocks(clock: Clock): ClockReading {
  for (let attempt = 1; ; attempt += 1) {
    const beforeMs = clock.monotonicMs();
    const wallMs = clock.nowMs();
    const monotonicMs = clock.monotonicMs();
    if (monotonicMs - beforeMs <= ONE_MOMENT_MS || attempt === ATTEMPTS)
      return { monotonicMs, wallMs };
  }
}

/** Difference between the advances of the wall clock and the monotonic clock between two readings, milliseconds. */
export function wallAheadMs(before: ClockReading, after: ClockReading): number {
  return after.wallMs - before.wallMs - (after.monotonicMs - before.monotonicMs);
}
