import { pause } from '../pause.ts';

const PERIOD_MS = 500;

/** Result of waiting for something. */
export interface Settled {
  /** How long it took, milliseconds. */
  readonly tookMs: number;
  /** What was still wrong when patience ended, in words; empty: all is well. */
  readonly problems: readonly string[];
}

/** Looks again and again until nothing is wrong. @param look finds what is wrong; what it throws is wrong, too */
export async function settle(
  look: () => Promise<readonly string[]>,
  patienceMs: number,
): Promise<Settled> {
  const begunMs = performance.now();
  for (;;) {
    const problems = await look().catch((error: unknown) => [String(error)]);
    const tookMs = performance.now() - begunMs;
    if (problems.length === 0 || tookMs > patienceMs) return { tookMs, problems };
    await pause(PERIOD_MS);
  }
}
