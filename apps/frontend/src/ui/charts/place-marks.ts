/** An event on the time axis. */
export interface ChartMark {
  readonly timeMs: number;
  readonly text: string;
}

/** Where a mark's words stand: at `x`, to the right of it or, near the right edge, to the left. */
export interface PlacedMark<M extends ChartMark> {
  readonly mark: M;
  readonly x: number;
  readonly side: 'left' | 'right';
  /** False when its words would run into a newer mark's; the line is drawn all the same. */
  readonly showText: boolean;
}

/**
 * Places marks, newest first served.
 * @param toX time to pixels
 * @param width pixels of the chart
 * @param textWidth pixels the words of a mark need, with icon and gap
 */
export function placeMarks<M extends ChartMark>(
  marks: readonly M[],
  toX: (timeMs: number) => number,
  width: number,
  textWidth: (mark: M) => number,
): PlacedMark<M>[] {
  const placed: PlacedMark<M>[] = [];
  let freeUntil = Infinity;
  for (const mark of [...marks].sort((a, b) => b.timeMs - a.timeMs)) {
    const x = toX(mark.timeMs);
    if (x < 0 || x > width) continue;
    const needed = textWidth(mark);
    const side = x + needed > width ? 'left' : 'right';
    const from = side === 'left' ? x - needed : x;
    const to = side === 'left' ? x : x + needed;
    const showText = from >= 0 && to <= freeUntil;
    if (showText) freeUntil = from;
    else freeUntil = Math.min(freeUntil, x);
    placed.push({ mark, x, side, showText });
  }
  return placed.reverse();
}
