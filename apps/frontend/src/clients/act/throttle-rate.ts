/** Lowest throttle, Hz: one record in ten seconds. [EX-31] */
const SLOWEST = 0.1;

/** Parses a rate in records per second; otherwise returns why it is invalid, one sentence. */
export function readThrottleRate(
  text: string,
): { readonly rate: number } | { readonly problem: string } {
  const written = text.trim().replace(',', '.');
  const rate = Number(written);
  if (written === '' || !Number.isFinite(rate)) {
    return { problem: 'Enter a number of records per second, such as 30.' };
  }
  if (rate < SLOWEST) {
    return {
      problem: `The minimum is ${SLOWEST}, one record in ten seconds. To stop the client, disconnect it.`,
    };
  }
  return { rate };
}

/** Default rate: half of the current rate, rounded. */
export function suggestThrottleRate(recordsPerSecond: number): number {
  const half = recordsPerSecond / 2;
  if (half < 1) return 1;
  const step = 10 ** Math.floor(Math.log10(half));
  return Math.max(1, Math.floor(half / step) * step);
}
