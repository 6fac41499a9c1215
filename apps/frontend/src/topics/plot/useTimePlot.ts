import { isSameValue } from '@ubii/proto';
import { useElementSize, usePreferredContrast } from '@vueuse/core';
import type uPlot from 'uplot';
import { onScopeDispose, shallowRef, watch, type Ref, type ShallowRef } from 'vue';
import { useIsDark } from '../../theme/useTheme.ts';
import { plotTheme } from '../../ui/plot/plot-theme.ts';
import { loadPlotLibrary } from '../../ui/plot/usePlot.ts';
import { nowMs, READING_MS, usePageFrames, type PageFrame } from '../history/page-clock.ts';
import type { NumberRange } from '../values/format-value.ts';
import { charactersIn, readLines, type LineText } from './line-texts.ts';
import { placeLabels } from './place-labels.ts';
import type { PlotLine } from './plot-line.ts';
import { characterWidth, PlotSizes } from './plot-sizes.ts';
import { endOf, type PlotView } from './plot-view.ts';
import { pointAt, type PlotPoint } from './read-plot.ts';
import type { SeriesLook } from './series-look.ts';
import { BOTTOM, TOP, timePlotOptions, type TimePlotScene } from './time-plot-options.ts';
import { ValueAxis } from './value-axis.ts';

/** Input of a plot. */
export interface TimePlotSource {
  /** Visible lines. */
  readonly lines: readonly PlotLine[];
  readonly looks: readonly SeriesLook[];
  readonly names: readonly string[];
  readonly view: PlotView;
  /** End of the data, this computer's clock; `undefined` for now. */
  readonly endMs: number | undefined;
  readonly endText: string;
  /** Times of the two cursors, this computer's clock. */
  readonly cursors: readonly number[];
}

/** Box of the plot area within the frame, pixels. */
export interface PlotBox {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
  /** Widths of the value axes, innermost first. */
  readonly axes: readonly number[];
}

/** Labels around the lines, updated as fast as they can be read, all of one instant. Pixels within the box. */
export interface TimePlotWords {
  /** Newest values by key of the line. */
  readonly values: ReadonlyMap<string, LineText>;
  /** Range of the value axis of each line, whose form its numbers have. */
  readonly ranges: readonly NumberRange[];
  readonly ends: readonly { readonly key: string; readonly y: number; readonly text: string }[];
  /** Values of the lines at the reading line. */
  readonly readings: readonly (PlotPoint | undefined)[];
  readonly dots: readonly { readonly key: string; readonly y: number }[];
}

/** Visible time range at this moment. */
export interface ShownTime {
  readonly startMs: number;
  readonly endMs: number;
  readonly newestMs: number;
}

/** Lines are drawn when they have moved by this many pixels, */
const STEP = 1.5;
/** and with each reading: the intervals are parts of it, so that lines of all plots end together, milliseconds. */
const STEPS_MS = [READING_MS / 2, READING_MS / 4];
/** Smallest distance between labels of lines, pixels. */
const LABEL_GAP = 17;

const NO_WORDS: TimePlotWords = {
  values: new Map(),
  ranges: [],
  ends: [],
  readings: [],
  dots: [],
};
const NO_BOX: PlotBox = { left: 0, top: 0, width: 0, height: 0, axes: [] };

/** Draws the lines of a plot with uPlot, frame by frame while the page is visible. */
export function useTimePlot(
  source: Readonly<Ref<TimePlotSource>>,
  frame: Readonly<Ref<HTMLElement | null>>,
  probe: Readonly<Ref<HTMLElement | null>>,
): {
  readonly box: Readonly<ShallowRef<PlotBox>>;
  readonly words: Readonly<ShallowRef<TimePlotWords>>;
  /** Updated with every drawn frame. */
  readonly shown: Readonly<ShallowRef<ShownTime>>;
  /** Position of the reading line, pixels from the left of the box; `undefined`: hidden. */
  readonly readingX: ShallowRef<number | undefined>;
  /** The canvas with the current drawing; `undefined` before the first. */
  canvas(): HTMLCanvasElement | undefined;
} {
  const library = shallowRef<typeof uPlot>();
  const plot = shallowRef<uPlot>();
  const box = shallowRef<PlotBox>(NO_BOX);
  const words = shallowRef<TimePlotWords>(NO_WORDS);
  const shown = shallowRef<ShownTime>({ startMs: 0, endMs: 0, newestMs: 0 });
  const readingX = shallowRef<number>();
  const { width, height } = useElementSize(frame);
  const [isDark, contrast] = [useIsDark(), usePreferredContrast()];
  const axes = new Map<string, ValueAxis>();
  let scene: TimePlotScene | undefined;
  let isDirty = true;
  let isGone = false;
  void loadPlotLibrary().then((loaded) => {
    if (!isGone) library.value = loaded;
  });

  /** Properties that require a new uPlot instance when they change. */
  const shape = (): string => {
    const { lines, looks } = source.value;
    const parts = lines.map((line, i) => [line.key, line.scale, looks[i]]);
    return JSON.stringify([parts, isDark.value, contrast.value]);
  };
  const isDrawable = (): boolean => width.value > 40 && height.value > 40;

  function make(): void {
    plot.value?.destroy();
    plot.value = undefined;
    const [root, swatch] = [frame.value, probe.value];
    if (!library.value || !root || !swatch || !isDrawable()) return;
    const { lines, looks } = source.value;
    scene = {
      lines,
      looks,
      scales: [...new Set(lines.map(({ scale }) => scale))].sort(),
      sizes: new PlotSizes(characterWidth(plotTheme(swatch).font)),
      window: { startMs: 0, endMs: 1, width: 1 },
      readMs: 0,
      isFollowing: true,
      endText: '',
    };
    const theme = plotTheme(swatch);
    const colorIn = (css: string): string => {
      swatch.style.color = css;
      return getComputedStyle(swatch).color;
    };
    const size = { width: Math.floor(width.value), height: Math.floor(height.value) };
    plot.value = new library.value(
      timePlotOptions(scene, theme, colorIn, size),
      // uPlot needs only scales; lines are drawn from their rings, per pixel.
      [[0, 1e15], ...lines.map(() => [null, null])] as uPlot.AlignedData,
      root,
    );
    measure(scene);
    isDirty = true;
  }

  function measure({ sizes, scales }: TimePlotScene): void {
    const axesOf = sizes.widths(scales);
    const left = axesOf.reduce((sum, one) => sum + one, 0);
    const next: PlotBox = {
      left,
      top: TOP,
      width: Math.max(1, Math.floor(width.value) - left - sizes.right),
      height: Math.max(1, Math.floor(height.value) - TOP - BOTTOM),
      axes: axesOf,
    };
    if (!isSameValue(next, box.value)) box.value = next;
  }

  watch([library, frame, probe, shape, isDrawable], make, { flush: 'post', immediate: true });
  watch([width, height], () => {
    if (!isDrawable() || !plot.value || !scene) return;
    plot.value.setSize({ width: Math.floor(width.value), height: Math.floor(height.value) });
    measure(scene);
    isDirty = true;
  });
  watch([source, readingX], () => (isDirty = true));
  onScopeDispose(() => {
    isGone = true;
    plot.value?.destroy();
  });

  usePageFrames((frame) => {
    if (!plot.value || !scene) return;
    const { view, endMs } = source.value;
    const newestMs = endMs ?? frame.nowMs;
    const end = endOf(view, { newestMs, oldestMs: -Infinity });
    const time: ShownTime = { startMs: end - view.spanMs, endMs: end, newestMs };
    if (isDirty || isDue(frame, time)) draw(plot.value, scene, time, frame);
    else if (frame.isReading && shown.value.newestMs !== newestMs) {
      shown.value = time;
      scene.readMs = endMs ?? frame.readMs;
      write(plot.value, scene);
    }
  });

  /** True when the lines have moved visibly. The moments are the same for all plots of a page. */
  function isDue({ nowMs: now, isReading }: PageFrame, { startMs, endMs }: ShownTime): boolean {
    const last = shown.value;
    if (endMs === last.endMs) return false;
    if (isReading) return true;
    const waitMs = (STEP * (endMs - startMs)) / box.value.width;
    if (waitMs >= READING_MS) return false;
    const stepMs = STEPS_MS.find((step) => step <= waitMs);
    return stepMs === undefined || Math.floor(now / stepMs) !== Math.floor(last.newestMs / stepMs);
  }

  function draw(on: uPlot, stage: TimePlotScene, time: ShownTime, frame: PageFrame): void {
    const isTimeForWords = isDirty || frame.isReading;
    isDirty = false;
    const { startMs, endMs } = time;
    const { view, endText, endMs: endOfAll } = source.value;
    stage.window = { startMs, endMs, width: box.value.width };
    stage.readMs = view.endMs ?? endOfAll ?? frame.readMs;
    stage.isFollowing = view.endMs === undefined;
    stage.endText = endText;
    const ranges = new Map<string, NumberRange>();
    on.batch(() => {
      on.setScale('x', { min: startMs, max: endMs });
      for (const scale of stage.scales) {
        let axis = axes.get(scale);
        if (!axis) axes.set(scale, (axis = new ValueAxis()));
        let range: { min: number; max: number } | undefined;
        for (const line of stage.lines) {
          if (line.scale !== scale) continue;
          const values = line.traced?.rangeIn(stage.window);
          if (!values) continue;
          range = range
            ? { min: Math.min(range.min, values.min), max: Math.max(range.max, values.max) }
            : values;
        }
        const shownRange = axis.follow(range, endOfAll === undefined ? endMs : nowMs());
        ranges.set(scale, shownRange);
        on.setScale(scale, shownRange);
      }
    });
    const widest = Math.max(0, ...[...ranges.values()].map(charactersIn));
    stage.sizes.fitLabels(widest, stage.lines.length > 1);
    shown.value = time;
    // uPlot draws in a microtask; positions are known afterwards.
    queueMicrotask(() => {
      if (plot.value !== on) return;
      measure(stage);
      if (isTimeForWords) write(on, stage);
    });
  }

  function write(on: uPlot, { lines, readMs: valuesMs }: TimePlotScene): void {
    const time = shown.value;
    const { width: boxWidth, height: boxHeight } = box.value;
    const { startMs, endMs } = time;
    const x = readingX.value;
    const readMs = x === undefined ? undefined : startMs + (x / boxWidth) * (endMs - startMs);
    const yOf = (line: PlotLine, value: number): number =>
      Number.isFinite(value) ? on.valToPos(value, line.scale) : 0;
    const readings = lines.map((line) =>
      readMs === undefined || !line.points ? undefined : pointAt(line.points, readMs, endMs),
    );
    const ranges = lines.map(({ scale }): NumberRange => {
      const { min, max } = on.scales[scale] ?? {};
      return { min: min ?? 0, max: max ?? 1 };
    });
    const values = readLines(lines, ranges, valuesMs);
    const wanted = lines.map((line) => yOf(line, values.get(line.key)?.value ?? Number.NaN));
    const hasRoom = lines.length * LABEL_GAP <= boxHeight;
    const places = placeLabels(wanted, LABEL_GAP, boxHeight);
    words.value = {
      values,
      ranges,
      ends: hasRoom
        ? lines.flatMap(({ key }, i) => {
            const text = values.get(key)?.text;
            return text === undefined ? [] : [{ key, y: places[i]!, text }];
          })
        : [],
      readings,
      dots: lines.flatMap((line, i) => {
        const value = readings[i]?.value ?? Number.NaN;
        return Number.isFinite(value) ? [{ key: line.key, y: yOf(line, value) }] : [];
      }),
    };
  }

  return {
    box,
    words,
    shown,
    readingX,
    canvas: () => plot.value?.ctx.canvas,
  };
}
