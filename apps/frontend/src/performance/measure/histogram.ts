import type { Histogram } from './findings.ts';

/**
 * All histograms have the same bins, so that any two runs can be overlaid: 20 per decade from 10 µs on, each 12 % wider
 * than the previous one. Shorter durations are in bin 0.
 */
const FIRST_EDGE_MS = 0.01;
const BINS_PER_DECADE = 20;
/** The last bin starts at 100 s. */
const LAST_BIN = 7 * BINS_PER_DECADE;

/** Lower edge of a bin, milliseconds. */
export function binStartMs(bin: number): number {
  return FIRST_EDGE_MS * 10 ** (bin / BINS_PER_DECADE);
}

export function binOf(durationMs: number): number {
  if (!(durationMs > FIRST_EDGE_MS)) return 0;
  // With a small offset: an edge belongs to the bin that it starts.
  const bin = Math.floor(BINS_PER_DECADE * Math.log10(durationMs / FIRST_EDGE_MS) + 1e-9);
  return Math.min(LAST_BIN, bin);
}

/** @param durationsMs in any order */
export function histogramOf(
  key: string,
  title: string,
  durationsMs: readonly number[],
): Histogram | undefined {
  if (durationsMs.length === 0) return undefined;
  const counts = new Map<number, number>();
  let [first, last] = [Infinity, -Infinity];
  for (const duration of durationsMs) {
    const bin = binOf(duration);
    counts.set(bin, (counts.get(bin) ?? 0) + 1);
    first = Math.min(first, bin);
    last = Math.max(last, bin);
  }
  return {
    key,
    title,
    firstBin: first,
    counts: Array.from({ length: last - first + 1 }, (_, index) => counts.get(first + index) ?? 0),
  };
}
