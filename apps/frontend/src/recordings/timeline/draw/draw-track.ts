import { colorOf, looksOf } from '../../../topics/plot/series-look.ts';
import type { FrameCache } from '../frame-cache.ts';
import type { SurveyedTrack } from '../survey.ts';
import type { TilePiece } from '../tile-store.ts';
import type { Track } from '../track.ts';
import { drawActivity, type UnreadActivity } from './draw-activity.ts';
import { columnsOf, drawEnvelope, drawLine, rangeOf } from './draw-lines.ts';
import { drawRuns, quietLabels } from './draw-runs.ts';
import { drawHeld, drawTicks } from './draw-ticks.ts';
import { filmSlots } from './film-strip.ts';
import { msPerPx, type Pen, type TrackInk, type TrackView } from './track-canvas.ts';

/** What a track is drawn from. */
export interface TrackSource {
  readonly track: Track;
  readonly surveyed: SurveyedTrack | undefined;
  /** Undefined when all of it was read. */
  readonly unread: UnreadActivity | undefined;
  readonly pieces: readonly TilePiece[];
  readonly frames: FrameCache<ImageBitmap>;
}

/** From so many records in a pixel on, one line is drawn as an envelope. */
const DENSE = 3;
/** Lines are interrupted after so many usual distances without a record, and after this long at least. */
const GAP = { distances: 8, ms: 1000 };
const FILM_MARGIN = 4;
const USUAL_ASPECT = 16 / 9;

/** Draws one track into its place. */
export function drawTrack(pen: Pen, source: TrackSource, view: TrackView, ink: TrackInk): void {
  const { track, surveyed, unread, pieces } = source;
  if (unread) {
    pen.fillStyle = ink.color(`var(--family-${track.family}-tint)`);
    drawActivity(pen, unread, pieces, view);
  }
  const color = ink.color(`var(--family-${track.family})`);
  pen.fillStyle = color;
  switch (track.kind) {
    case 'lines':
      return drawNumbers(pen, source, view, ink);
    case 'ticks':
      drawTicks(pen, pieces, view, view.heightPx * 0.34);
      return drawHeld(pen, surveyed?.runs ?? [], view);
    case 'frames':
      return drawFrames(pen, source, view, ink);
    case 'bars':
    case 'text': {
      const runs = surveyed?.runs ?? [];
      const isText = track.kind === 'text';
      const lanes = isText ? 1 : Math.max(2, ...runs.map(({ lane }) => lane + 1));
      const quiet = isText ? quietLabels(runs) : new Set<string>();
      return drawRuns(pen, runs, view, { family: track.family, quiet, lanes, hasText: true }, ink);
    }
    case 'bytes':
      return drawTicks(pen, pieces, view, view.heightPx * 0.3);
  }
}

function drawNumbers(
  pen: Pen,
  { track, surveyed, pieces }: TrackSource,
  view: TrackView,
  ink: TrackInk,
): void {
  const range = surveyed && rangeOf(surveyed.tile);
  if (surveyed === undefined || range === undefined) return;
  const count = surveyed.tile.lines.length;
  const isDense = count === 1 && (track.hz / 1000) * msPerPx(view) >= DENSE;
  if (isDense) return drawEnvelope(pen, columnsOf(pieces, 0, view), range, view);
  const usualMs = track.hz > 0 ? 1000 / track.hz : 0;
  const gapMs = Math.max(GAP.ms, usualMs * GAP.distances);
  pen.lineJoin = 'round';
  pen.lineWidth = 1.5;
  for (const [index, look] of looksOf(
    Array.from({ length: count }, () => track.family),
  ).entries()) {
    pen.strokeStyle = ink.color(colorOf(look));
    // Dashes of a dense line are noise
    pen.setLineDash([...look.dash]);
    drawLine(pen, columnsOf(pieces, index, view), range, view, gapMs);
  }
  pen.setLineDash([]);
}

function drawFrames(
  pen: Pen,
  { track, surveyed, frames }: TrackSource,
  view: TrackView,
  ink: TrackInk,
): void {
  if (surveyed === undefined) return;
  const height = view.heightPx - 2 * FILM_MARGIN;
  const first = surveyed.frames[0];
  const shape = first === undefined ? undefined : frames.get(track.topic, first);
  const width = height * (shape ? shape.width / shape.height : USUAL_ASPECT);
  for (const { x, widthPx, frameMs } of filmSlots(
    surveyed.frames,
    view.span,
    view.widthPx,
    width,
  )) {
    if (frameMs === undefined) continue;
    const picture = frames.get(track.topic, frameMs);
    if (picture) drawCovering(pen, picture, { x, y: FILM_MARGIN, width: widthPx - 1, height });
    else {
      pen.fillStyle = ink.color(`var(--family-${track.family}-tint)`);
      pen.fillRect(x, FILM_MARGIN, widthPx - 1, height);
    }
  }
}

/** Fills a place with the middle of a picture, which is never stretched. */
function drawCovering(
  pen: Pen,
  picture: ImageBitmap,
  { x, y, width, height }: { x: number; y: number; width: number; height: number },
): void {
  const scale = Math.max(width / picture.width, height / picture.height);
  const [sw, sh] = [width / scale, height / scale];
  const [sx, sy] = [(picture.width - sw) / 2, (picture.height - sh) / 2];
  pen.drawImage(picture, sx, sy, sw, sh, x, y, width, height);
}
