import { timeAt } from '../span.ts';
import type { TilePiece } from '../tile-store.ts';
import { msPerPx, type Pen, type TrackView } from './track-canvas.ts';

/** How many records of a track came when, where they were not read yet. */
export interface UnreadActivity {
  /** Records in parts of equal length of the whole recording. */
  readonly counts: Float32Array;
  readonly durationMs: number;
  /** Up to here the records were read, milliseconds. */
  readonly readMs: number;
}

const BAR_PX = 2;
/** Parts that are wider than this say too little of when records came. */
const MAX_PART_PX = 16;
/** Share of the height of the track that the part with most records has. */
const HIGHEST = 0.7;
const LOWEST_PX = 2;

/**
 * Draws where records are that were not read, the more the higher, in the current colour.
 * @param pieces what is drawn of the track: stretches that were read are left out
 */
export function drawActivity(
  pen: Pen,
  { counts, durationMs, readMs }: UnreadActivity,
  pieces: readonly TilePiece[],
  view: TrackView,
): void {
  const { span, widthPx, heightPx } = view;
  const most = counts.reduce((highest, count) => Math.max(highest, count), 0);
  if (most === 0 || durationMs / counts.length > MAX_PART_PX * msPerPx(view)) return;
  const read = [{ fromMs: 0, untilMs: readMs }, ...pieces.filter(({ tile }) => tile.isWhole)];
  for (let x = 0; x < widthPx; x += BAR_PX) {
    const timeMs = timeAt(x + BAR_PX / 2, span, widthPx);
    if (read.some(({ fromMs, untilMs }) => timeMs >= fromMs && timeMs < untilMs)) continue;
    const count = counts[Math.floor((timeMs / durationMs) * counts.length)] ?? 0;
    if (count === 0) continue;
    const height = Math.max(LOWEST_PX, Math.sqrt(count / most) * HIGHEST * heightPx);
    pen.fillRect(x, (heightPx - height) / 2, BAR_PX, height);
  }
}
