import { useElementSize, usePreferredContrast } from '@vueuse/core';
import type uPlot from 'uplot';
import { onScopeDispose, shallowRef, watch, type Ref, type ShallowRef } from 'vue';
import { useIsDark } from '../../theme/useTheme.ts';
import type { PlotChart } from './plot-chart.ts';
import { plotOptions } from './plot-options.ts';
import { plotTheme } from './plot-theme.ts';

type Library = typeof uPlot;

/** Loads uPlot and its styles on first use. */
export async function loadPlotLibrary(): Promise<Library> {
  const [{ default: library }] = await Promise.all([
    import('uplot'),
    import('uplot/dist/uPlot.min.css'),
  ]);
  return library;
}

/** Position of the reading line: index in `x`. */
export interface PlotReading {
  readonly index: number;
  /** Pixels from the left of the frame. */
  readonly left: number;
}

/** Maintains a plot in `frame`: recreated when its lines, the theme or the contrast change, otherwise updated. */
export function usePlot(
  chart: Readonly<Ref<PlotChart>>,
  frame: Readonly<Ref<HTMLElement | null>>,
  probe: Readonly<Ref<HTMLElement | null>>,
): {
  readonly reading: Readonly<ShallowRef<PlotReading | undefined>>;
  /** The uPlot instance, for callers that need more of it; `undefined` until it is loaded. */
  readonly plot: Readonly<ShallowRef<uPlot | undefined>>;
  /** Moves the reading line by a number of values. */
  step(by: number): void;
  clearReading(): void;
} {
  const library = shallowRef<Library>();
  const plot = shallowRef<uPlot>();
  const reading = shallowRef<PlotReading>();
  const { width, height } = useElementSize(frame);
  const isDark = useIsDark();
  const contrast = usePreferredContrast();
  let isGone = false;
  void loadPlotLibrary().then((loaded) => {
    if (!isGone) library.value = loaded;
  });

  /** Properties that require a new uPlot instance when they change. */
  const shape = (): string => {
    const { lines, xAxis, yAxis } = chart.value;
    const looks = lines.map(({ label, kind, stroke }) => [label, kind, stroke]);
    return JSON.stringify([looks, xAxis, yAxis, isDark.value, contrast.value]);
  };
  const isDrawable = (): boolean => width.value > 0 && height.value > 0;
  const dataOf = ({ x, lines }: PlotChart): uPlot.AlignedData =>
    [[...x], ...lines.map(({ values }) => [...values])] as uPlot.AlignedData;

  function read(from: uPlot): void {
    const { idx, left } = from.cursor;
    const isOn = idx !== null && idx !== undefined && left !== undefined && left >= 0;
    reading.value = isOn ? { index: idx, left } : undefined;
  }

  function make(): void {
    plot.value?.destroy();
    plot.value = undefined;
    if (!library.value || !frame.value || !probe.value || !isDrawable()) return;
    const size = { width: Math.floor(width.value), height: Math.floor(height.value) };
    const options = plotOptions(library.value, chart.value, plotTheme(probe.value), size);
    options.hooks = { ...options.hooks, setCursor: [read] };
    plot.value = new library.value(options, dataOf(chart.value), frame.value);
  }

  watch([library, frame, probe, shape, isDrawable], make, { flush: 'post', immediate: true });
  watch(chart, (next) => plot.value?.setData(dataOf(next)), { flush: 'post' });
  watch([width, height], () => {
    const size = { width: Math.floor(width.value), height: Math.floor(height.value) };
    if (isDrawable()) plot.value?.setSize(size);
  });
  onScopeDispose(() => {
    isGone = true;
    plot.value?.destroy();
  });

  return {
    reading,
    plot,
    step(by) {
      const { x } = chart.value;
      if (!plot.value || x.length === 0) return;
      const from = reading.value?.index ?? (by > 0 ? -1 : x.length);
      const index = Math.min(x.length - 1, Math.max(0, from + by));
      const left = plot.value.valToPos(x[index]!, 'x');
      plot.value.setCursor({ left, top: 0 });
      reading.value = { index, left };
    },
    clearReading() {
      plot.value?.setCursor({ left: -10, top: -10 });
      reading.value = undefined;
    },
  };
}
