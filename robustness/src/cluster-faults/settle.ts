import { pause } from '../pause.ts';

const PERIOD_MS = 500;
/** Who waits for long says so that often. */
const SAY_MS = 20_000;

/** Result of waiting for something. */
export interface Settled {
  /** How long it took, milliseconds. */
  readonly tookMs: number;
  /** What was still wrong when patience ended, in words; empty: all is well. */
  readonly problems: readonly string[];
}

/**
 * Looks again and again until nothing is wrong.
 *
 * @param look finds what is wrong; what it throws is wrong, too
 * @param say is told what is still wrong, now and then
 */
export async function settle(
  look: () => Promise<readonly string[]>,
  patienceMs: number,
  say: (text: string) => void,
): Promise<Settled> {
  const begunMs = performance.now();
  let saidMs = 0;
  for (;;) {
    const problems = await look().catch((error: unknown) => [String(error)]);
    const tookMs = performance.now() - begunMs;
    if (problems.length === 0 || tookMs > patienceMs) return { tookMs, problems };
    if (tookMs - saidMs > SAY_MS) {
      saidMs = tookMs;
      say(`  after ${Math.round(tookMs / 1000)} s: ${problems.slice(0, 3).join('; ')}`);
    }
    await pause(PERIOD_MS);
  }
}
