import { onScopeDispose, watch, type Ref } from 'vue';
import { perFrame } from '../../connection/per-frame.ts';
import { useIsDark } from '../../theme/useTheme.ts';
import { drawTrack } from '../timeline/draw/draw-track.ts';
import { trackInk } from '../timeline/draw/ink.ts';
import { msPerPx, type Pen, type TrackInk, type TrackView } from '../timeline/draw/track-canvas.ts';
import type { Track } from '../timeline/track.ts';
import type { Timeline } from './useTimeline.ts';

/** Prepares a canvas of a size in CSS pixels, cleared. */
export function penOf(
  canvas: HTMLCanvasElement,
  widthPx: number,
  heightPx: number,
): Pen | undefined {
  const scale = devicePixelRatio;
  const [width, height] = [Math.round(widthPx * scale), Math.round(heightPx * scale)];
  if (canvas.width !== width) canvas.width = width;
  if (canvas.height !== height) canvas.height = height;
  const pen = canvas.getContext('2d');
  pen?.setTransform(scale, 0, 0, scale, 0, 0);
  pen?.clearRect(0, 0, widthPx, heightPx);
  return pen ?? undefined;
}

/** Keeps what is drawn on a canvas as its sources are: at most once a frame. */
export function useDrawing(
  canvas: Readonly<Ref<HTMLCanvasElement | null>>,
  probe: Readonly<Ref<HTMLElement | null>>,
  sources: () => unknown,
  draw: (canvas: HTMLCanvasElement, ink: TrackInk) => void,
): void {
  const isDark = useIsDark();
  let ink: TrackInk | undefined;
  let isOver = false;
  const redraw = perFrame(() => {
    if (isOver || canvas.value === null || probe.value === null) return;
    draw(canvas.value, (ink ??= trackInk(probe.value)));
  });
  watch(isDark, () => (ink = undefined));
  watch([sources, isDark, canvas], redraw, { immediate: true, flush: 'post' });
  onScopeDispose(() => (isOver = true));
}

/** Draws a track of a timeline, in the view it is given. */
export function useTrackDrawing(
  canvas: Readonly<Ref<HTMLCanvasElement | null>>,
  probe: Readonly<Ref<HTMLElement | null>>,
  timeline: Timeline,
  track: () => Track,
  view: () => TrackView,
): void {
  const { tiles, frames, drawn } = timeline.opened;
  useDrawing(
    canvas,
    probe,
    () => [
      ...[view(), track(), drawn.value],
      ...[timeline.opened.survey.value, timeline.opened.activity.value],
    ],
    (element, ink) => {
      const now = view();
      const pen = penOf(element, now.widthPx, now.heightPx);
      if (pen === undefined) return;
      const { topic } = track();
      const pieces = tiles.pieces(topic, now.span, msPerPx(now));
      const surveyed = timeline.surveyed(topic);
      const unread = timeline.unread(topic);
      drawTrack(pen, { track: track(), surveyed, unread, pieces, frames }, now, ink);
    },
  );
}
