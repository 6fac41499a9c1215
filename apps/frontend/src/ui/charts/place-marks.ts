/** An event on the time axis. */
export interface ChartMark {
  readonly timeMs: number;
  readonly text: string;
}

/** Where a mark and its words stand. */
export interface PlacedMark<M extends ChartMark> {
  /** The newest of those that fall together. */
  readonly mark: M;
  /** How many older ones stand at the same place. */
  readonly folded: number;
  readonly x: number;
  /** The words stand to the right of the line or, near the right edge, to the left. */
  readonly side: 'left' | 'right';
  /** False when the words would run into a newer mark's; the line is drawn anyway. */
  readonly showText: boolean;
}

/** Marks closer than this look like one, pixels. */
const SAME_PLACE = 12;
/** What ` +3` takes, pixels. */
const FOLDED_WIDTH = 20;

function fold<M extends ChartMark>(marks: readonly M[], toX: (timeMs: number) => number) {
  const places: { mark: M; x: number; folded: number }[] = [];
  for (const mark of [...marks].sort((a, b) => b.timeMs - a.timeMs)) {
    const x = toX(mark.timeMs);
    const newer = places.at(-1);
    if (newer && newer.x - x < SAME_PLACE) newer.folded += 1;
    else places.push({ mark, x, folded: 0 });
  }
  return places;
}

/**
 * Places marks on a chart; where there is no room for all words, the newest have them. Oldest first.
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
  for (const { mark, x, folded } of fold(marks, toX)) {
    if (x < 0 || x > width) continue;
    const needed = textWidth(mark) + (folded > 0 ? FOLDED_WIDTH : 0);
    const side = x + needed > width ? 'left' : 'right';
    const from = side === 'left' ? x - needed : x;
    const to = side === 'left' ? x : x + needed;
    const showText = from >= 0 && to <= freeUntil;
    freeUntil = showText ? from : Math.min(freeUntil, x);
    placed.push({ mark, folded, x, side, showText });
  }
  return placed.reverse();
}
