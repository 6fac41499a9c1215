import { pause } from '../pause.ts';

const PERIOD_MS = 500;
/** Interval of messages about a long wait. */
const SAY_MS = 20_000;

/** Result of waiting for something. */
export interface Settled {
  /** How long it took, milliseconds. */
  readonly tookMs: number;
  /** Problems that were left at the time limit; empty when there are none. */
  readonly problems: readonly string[];
}

/**
 * Polls until there are no problems, or until the time limit.
 *
 * @param look finds problems; what it throws is a problem, too
 * @param say receives the problems that are left, now and then
 */
export async function settle(
  look: () => Promise<readonly string[]>,
  timeoutMs: number,
  say: (text: string) => void,
): Promise<Settled> {
  const begunMs = performance.now();
  let saidMs = 0;
  for (;;) {
    const problems = await look().catch((error: unknown) => [String(error)]);
    const tookMs = performance.now() - begunMs;
    if (problems.length === 0 || tookMs > timeoutMs) return { tookMs, problems };
    if (tookMs - saidMs > SAY_MS) {
      saidMs = tookMs;
      say(`  after ${Math.round(tookMs / 1000)} s: ${problems.slice(0, 3).join('; ')}`);
    }
    await pause(PERIOD_MS);
  }
}
