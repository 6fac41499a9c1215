import { computed, watch, type ComputedRef } from 'vue';
import { lengthOf, type Span } from '../timeline/span.ts';
import type { TileViewer } from '../timeline/tile-store.ts';
import { useTimeline } from './useTimeline.ts';

/**
 * The time around the playhead, for plots of tracks; asks for what they draw.
 *
 * @param aroundMs before and after the playhead
 */
export function usePlotSpan(
  viewer: TileViewer,
  topics: () => readonly string[],
  aroundMs: () => number,
  widthPx: () => number,
): ComputedRef<Span> {
  const { opened } = useTimeline();
  const span = computed(() => ({
    fromMs: opened.timeMs.value - aroundMs(),
    untilMs: opened.timeMs.value + aroundMs(),
  }));
  watch(
    [span, topics, widthPx, opened.survey],
    () => {
      if (opened.survey.value === undefined || widthPx() < 1) return;
      opened.tiles.want(viewer, topics(), span.value, lengthOf(span.value) / widthPx());
    },
    { immediate: true },
  );
  return span;
}
