import type { RandomSource } from '../ports/random.ts';

/** When to try again after the link failed. */
export interface ReconnectPolicy {
  /** Delay before the first attempt after the link broke, milliseconds. @default 250 */
  readonly initialDelayMs: number;
  /** Each further delay is this many times the one before. @default 1.7 */
  readonly factor: number;
  /** No delay is longer, milliseconds. @default 5000 */
  readonly maxDelayMs: number;
  /**
   * Longest delay while there is no answer, milliseconds, so that a restarted master is found soon. The
   * longer delay is for a master that answers and refuses the client. [CL-43] @default 1500
   */
  readonly maxUnansweredDelayMs: number;
  /**
   * Share of a delay that is left to chance, 0 to 1, so that many clients do not come back in the
   * same instant after a restart of the master. @default 0.5
   */
  readonly jitter: number;
  /**
   * Failed attempts in a row before the client gives up and its state is `closed`; 1 gives up when
   * the first `connect()` fails, 0 never reconnects. @default Infinity
   */
  readonly giveUpAfterAttempts: number;
  /**
   * A link that held this long, milliseconds, starts the count of failures again when it breaks; one
   * that broke earlier counts as a failed attempt itself, so that a master that throws the client out
   * again and again is left alone. @default 5000
   */
  readonly stableAfterMs: number;
}

/** The defaults. A local master that restarts has its clients back within a second or two. */
export const DEFAULT_RECONNECT_POLICY: ReconnectPolicy = {
  initialDelayMs: 250,
  factor: 1.7,
  maxDelayMs: 5_000,
  maxUnansweredDelayMs: 1_500,
  jitter: 0.5,
  giveUpAfterAttempts: Infinity,
  stableAfterMs: 5_000,
};

/**
 * Returns the delay before the next attempt: exponential back-off, reduced by a random jitter up to its share.
 * @param failedAttempts number of consecutive failures; 0 after a stable connection broke
 * @param isAnswered true when the master replied, but refused the client
 * @returns milliseconds, or `undefined` when the policy gives up
 */
export function reconnectDelayMs(
  policy: ReconnectPolicy,
  failedAttempts: number,
  random: RandomSource,
  isAnswered = true,
): number | undefined {
  if (failedAttempts >= policy.giveUpAfterAttempts) return undefined;
  const fullMs = Math.min(
    policy.maxDelayMs,
    isAnswered ? Infinity : policy.maxUnansweredDelayMs,
    policy.initialDelayMs * policy.factor ** failedAttempts,
  );
  return fullMs * (1 - policy.jitter * random());
}
