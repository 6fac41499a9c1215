import { computed, onScopeDispose, shallowRef, watch, type ComputedRef, type Ref } from 'vue';
import { formatLook } from '../../formats/families.ts';
import type { FeedSource } from '../history/topic-feeds.ts';
import type { TopicHistory } from '../history/topic-history.ts';
import { PlotLine } from './plot-line.ts';
import { seriesKey, type PlotSeries } from './plot-settings.ts';
import { looksOf, seriesNames, type SeriesLook } from './series-look.ts';

/** Interval of checks for the formats of topics without a value, milliseconds. */
const FORMATS_MS = 250;

/**
 * Lines of a plot from the histories of their topics. Subscribes topics other than the plot's own while the plot is
 * mounted.
 */
export function usePlotLines(
  series: Readonly<Ref<readonly PlotSeries[]>>,
  own: () => { readonly topic: string | undefined; readonly history: TopicHistory },
  feeds: FeedSource,
): {
  readonly lines: ComputedRef<readonly PlotLine[]>;
  readonly looks: ComputedRef<readonly SeriesLook[]>;
  readonly names: ComputedRef<readonly string[]>;
} {
  const looking = new Map<string, () => void>();
  watch(
    [series, () => own().topic],
    ([all, ownTopic]) => {
      const others = new Set(all.map(({ topic }) => topic).filter((topic) => topic !== ownTopic));
      for (const topic of others) {
        if (!looking.has(topic)) looking.set(topic, feeds.get(topic).look());
      }
      for (const [topic, stop] of looking) {
        if (others.has(topic)) continue;
        stop();
        looking.delete(topic);
      }
    },
    { immediate: true },
  );

  // Keep unchanged lines with their processed points.
  let kept = new Map<string, PlotLine>();
  const lines = computed(() => {
    const { topic: ownTopic, history } = own();
    const next = new Map<string, PlotLine>();
    const all = series.value.map((one) => {
      const source = one.topic === ownTopic ? history : feeds.get(one.topic).history;
      const before = kept.get(seriesKey(one));
      const line =
        before?.history === source && before.series === one ? before : new PlotLine(one, source);
      next.set(line.key, line);
      return line;
    });
    kept = next;
    return all;
  });

  const formats = shallowRef<readonly string[]>([]);
  function readFormats(): void {
    const now = lines.value.map(({ format }) => format ?? '');
    if (now.join() !== formats.value.join()) formats.value = now;
  }
  watch(lines, readFormats, { immediate: true });
  const timer = setInterval(readFormats, FORMATS_MS);
  onScopeDispose(() => {
    clearInterval(timer);
    for (const stop of looking.values()) stop();
  });

  return {
    lines,
    looks: computed(() =>
      looksOf(lines.value.map((_line, i) => formatLook(formats.value[i] ?? '').family)),
    ),
    names: computed(() => seriesNames(series.value)),
  };
}
