/** A stage on the bar. */
export interface PlacedStage {
  /** Pixels from the left end of the bar. */
  readonly x: number;
  readonly width: number;
}

/** Smallest width of a stage, pixels, so that it is visible. */
const MIN_WIDTH = 2;

/** Places stages one after the other, to scale; their sum is the whole bar. */
export function placeStages(
  durations: readonly number[],
  width: number,
  gap: number,
): PlacedStage[] {
  const sum = durations.reduce((total, ms) => total + ms, 0) || 1;
  const least = Math.min(MIN_WIDTH, width / Math.max(1, durations.length));
  const wished = durations.map((ms) => Math.max(least, (ms / sum) * width));
  const scale = width / wished.reduce((total, one) => total + one, 0);
  let x = 0;
  return wished.map((one) => {
    const placed = { x, width: Math.max(0, one * scale - gap) };
    x += one * scale;
    return placed;
  });
}

/** Returns the ticks of the scale, milliseconds: at most eight steps, of 1, 2 or 5 times a power of ten. */
export function stageTicks(totalMs: number): number[] {
  if (!(totalMs > 0)) return [];
  const power = 10 ** Math.floor(Math.log10(totalMs / 8));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((one) => totalMs / one <= 8)!;
  return Array.from({ length: Math.floor(totalMs / step) + 1 }, (_, index) => index * step);
}

/** Label of a position on the bar. */
export interface StageLabel {
  readonly x: number;
  readonly width: number;
  /** Without room for all, labels with the lowest weight are omitted. */
  readonly weight: number;
}

/**
 * Moves labels apart so that they do not overlap, each as near as possible to its position.
 * @returns pixels from the left, `undefined` for an omitted label
 */
export function spreadLabels(
  labels: readonly StageLabel[],
  total: number,
  gap: number,
): (number | undefined)[] {
  const kept = new Set(labels);
  const needed = (): number =>
    [...kept].reduce((sum, { width }) => sum + width + gap, 0) - (kept.size > 0 ? gap : 0);
  for (const label of [...labels].sort((a, b) => a.weight - b.weight)) {
    if (needed() <= total) break;
    kept.delete(label);
  }
  const shown = [...kept];
  const places = new Map<StageLabel, number>();
  let end = -gap;
  for (const label of shown) {
    const x = Math.max(label.x, end + gap);
    places.set(label, x);
    end = x + label.width;
  }
  let limit = total;
  for (const label of shown.reverse()) {
    const x = Math.min(places.get(label)!, limit - label.width);
    places.set(label, x);
    limit = x - gap;
  }
  return labels.map((label) => places.get(label));
}
