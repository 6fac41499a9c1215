/**
 * Moves labels apart so that they do not overlap, as little as possible and in their order.
 * @param wanted preferred positions, pixels from the top, in any order
 * @param gap between the centres of two labels, pixels
 * @param bottom lowest position
 * @returns final positions, in the order of `wanted`
 */
export function placeLabels(wanted: readonly number[], gap: number, bottom: number): number[] {
  const order = wanted.map((_, i) => i).sort((a, b) => wanted[a]! - wanted[b]!);
  const placed = [...wanted];
  let above = -Infinity;
  for (const i of order) {
    above = placed[i] = Math.max(wanted[i]!, above + gap, 0);
  }
  let below = Infinity;
  for (const i of order.reverse()) {
    below = placed[i] = Math.min(placed[i]!, below - gap, bottom);
  }
  return placed;
}
