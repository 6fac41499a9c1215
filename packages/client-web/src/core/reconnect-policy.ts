import type { RandomSource } from './ports/random.ts';

/** When to try again after the link failed. */
export interface ReconnectPolicy {
  /** Delay before the first attempt, milliseconds. @default 250 */
  readonly initialDelayMs: number;
  /** Each further delay is this many times the one before. @default 1.7 */
  readonly factor: number;
  /** No delay is longer, milliseconds. @default 5000 */
  readonly maxDelayMs: number;
  /**
   * Share of a delay that is left to chance, 0 to 1, so that many clients do not come back in the
   * same instant after a restart of the master. @default 0.5
   */
  readonly jitter: number;
  /** Failed attempts in a row before the client gives up and its state is `closed`. @default Infinity */
  readonly giveUpAfterAttempts: number;
  /**
   * A link that held this long, milliseconds, starts the count of attempts anew when it fails; one
   * that broke earlier goes on from where it was, so that a master that throws us out is left alone.
   * @default 5000
   */
  readonly stableAfterMs: number;
}

/** The defaults. A local master that restarts has its clients back within a second or two. */
export const DEFAULT_RECONNECT_POLICY: ReconnectPolicy = {
  initialDelayMs: 250,
  factor: 1.7,
  maxDelayMs: 5_000,
  jitter: 0.5,
  giveUpAfterAttempts: Infinity,
  stableAfterMs: 5_000,
};

/**
 * How long to wait before an attempt.
 * @param attempt 1 for the first attempt after the link failed
 * @returns milliseconds, or `undefined` when the policy says to give up
 */
export function reconnectDelayMs(
  policy: ReconnectPolicy,
  attempt: number,
  random: RandomSource,
): number | undefined {
  if (attempt > policy.giveUpAfterAttempts) return undefined;
  const fullMs = Math.min(
    policy.maxDelayMs,
    policy.initialDelayMs * policy.factor ** (attempt - 1),
  );
  return fullMs * (1 - policy.jitter * random());
}
