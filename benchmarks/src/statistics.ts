/**
 * The value below which `fraction` of the values lie, by nearest rank (no interpolation).
 *
 * @param sorted ascending
 * @param fraction 0 to 1
 * @returns NaN for no values
 */
export function percentile(sorted: ArrayLike<number>, fraction: number): number {
  if (sorted.length === 0) return Number.NaN;
  const rank = Math.ceil(fraction * sorted.length);
  return sorted[Math.min(sorted.length, Math.max(1, rank)) - 1]!;
}

/** The middle value; of an even number of values the mean of the two in the middle. NaN for none. */
export function median(values: Iterable<number>): number {
  const sorted = Float64Array.from(values).sort();
  if (sorted.length === 0) return Number.NaN;
  const middle = sorted.length >> 1;
  return sorted.length % 2 === 1 ? sorted[middle]! : (sorted[middle - 1]! + sorted[middle]!) / 2;
}

/** value / reference, pair by pair: both were measured in the same round. */
export function ratiosOf(values: readonly number[], references: readonly number[]): number[] {
  if (values.length !== references.length) {
    throw new RangeError(`Expected pairs, got ${values.length} and ${references.length} values.`);
  }
  return values.map((value, round) => value / references[round]!);
}
