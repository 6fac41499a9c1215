/** Event on the time axis. */
export interface ChartMark {
  readonly timeMs: number;
  readonly text: string;
}

/** Position of a mark and its text. */
export interface PlacedMark<M extends ChartMark> {
  /** Newest of several marks at the same position. */
  readonly mark: M;
  /** Number of older marks at the same position. */
  readonly folded: number;
  readonly x: number;
  /** Side of the text: right of the line, or left near the right edge. */
  readonly side: 'left' | 'right';
  /** False when the text would overlap that of a newer mark; the line is drawn anyway. */
  readonly showText: boolean;
}

/** Distance below which marks are merged, pixels. */
const SAME_PLACE = 12;
/** Width of ` +3`, pixels. */
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
 * Positions marks on a chart; without room for all texts, the newest marks have theirs. Oldest first.
 * @param toX time to pixels
 * @param width of the chart, pixels
 * @param textWidth width of a mark's text with icon and gap, pixels
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
