/** Means over about this time, milliseconds. */
const WINDOW_MS = 1_000;

/** Turns a count that grows into a rate. */
export interface RunRate {
  /** @returns runs per second since about a second ago; 0 at first, and after the count began again */
  measure(count: number): number;
}

/** @param nowMs a clock that only goes forward */
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
