/** Approximate window of the mean, milliseconds. */
const WINDOW_MS = 1_000;

/** Converts a growing count to a rate. */
export interface RunRate {
  /** @returns runs per second over about a second; 0 initially, and after the count was reset */
  measure(count: number): number;
}

/** @param nowMs returns the time of a monotonic clock */
export function createRunRate(nowMs: () => number): RunRate {
  let samples: { readonly ms: number; readonly count: number }[] = [];
  return {
    measure(count) {
      const ms = nowMs();
      const before = samples.at(-1);
      if (before !== undefined && count < before.count) samples = [];
      samples.push({ ms, count });
      while (samples.length > 2 && ms - (samples[1]?.ms ?? ms) >= WINDOW_MS) samples.shift();
      const [first] = samples;
      if (first === undefined || ms <= first.ms) return 0;
      return ((count - first.count) * 1000) / (ms - first.ms);
    },
  };
}
