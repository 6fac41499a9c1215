/** Milliseconds of nanoseconds, with fractions. */
export function msOf(ns: bigint): number {
  return Number(ns / 1000n) / 1000;
}

/** Nanoseconds of milliseconds, to the microsecond. */
export function nsOf(ms: number): bigint {
  return BigInt(Math.round(ms * 1000)) * 1000n;
}
