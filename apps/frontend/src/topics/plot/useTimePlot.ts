import { useElementSize, usePreferredContrast, useRafFn } from '@vueuse/core';
import type uPlot from 'uplot';
import { onScopeDispose, shallowRef, watch, type Ref, type ShallowRef } from 'vue';
import { useIsDark } from '../../theme/useTheme.ts';
import { plotTheme } from '../../ui/plot/plot-theme.ts';
import { loadPlotLibrary } from '../../ui/plot/usePlot.ts';
import { nowMs } from '../history/topic-feeds.ts';
import { formatFixed } from '../values/format-value.ts';
import { placeLabels } from './place-labels.ts';
import type { PlotLine } from './plot-line.ts';
import { endOf, type PlotView } from './plot-view.ts';
import { pointAt, pointNear, type PlotPoint } from './read-plot.ts';
import type { SeriesLook } from './series-look.ts';
import {
  AXIS_WIDTH,
  BOTTOM,
  TOP,
  timePlotOptions,
  type TimePlotScene,
} from './time-plot-options.ts';
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
}

/** Labels around the lines, updated as fast as they can be read. Pixels within the box. */
export interface TimePlotWords {
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

const RIGHT = 92;
const NARROW_RIGHT = 64;
const NARROW = 480;
/** A frame is drawn when the lines have moved by this many pixels, */
const STEP = 1.5;
/** or after the time that a pixel takes, within these limits, milliseconds. */
const MIN_WAIT_MS = 50;
const MAX_WAIT_MS = 250;
/** Interval between updates of labels, milliseconds: as fast as digits can be read. */
const WORDS_MS = 125;
/** Smallest distance between labels of lines, pixels. */
const LABEL_GAP = 17;

const NO_WORDS: TimePlotWords = { ends: [], readings: [], dots: [] };
const NO_BOX: PlotBox = { left: 0, top: 0, width: 0, height: 0 };

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
  let wordsMs = 0;
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
      right: width.value < NARROW ? NARROW_RIGHT : RIGHT,
      window: { startMs: 0, endMs: 1, width: 1 },
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
    measure();
    isDirty = true;
  }

  function measure(): void {
    const left = AXIS_WIDTH * Math.max(1, scene?.scales.length ?? 1);
    box.value = {
      left,
      top: TOP,
      width: Math.max(1, Math.floor(width.value) - left - (scene?.right ?? RIGHT)),
      height: Math.max(1, Math.floor(height.value) - TOP - BOTTOM),
    };
  }

  watch([library, frame, probe, shape, isDrawable], make, { flush: 'post', immediate: true });
  watch([width, height], () => {
    if (!isDrawable() || !plot.value || !scene) return;
    const right = width.value < NARROW ? NARROW_RIGHT : RIGHT;
    if (right !== scene.right) return make();
    plot.value.setSize({ width: Math.floor(width.value), height: Math.floor(height.value) });
    measure();
    isDirty = true;
  });
  watch([source, readingX], () => (isDirty = true));
  onScopeDispose(() => {
    isGone = true;
    plot.value?.destroy();
  });

  useRafFn(() => {
    if (!plot.value || !scene) return;
    const { view, endMs } = source.value;
    const newestMs = endMs ?? nowMs();
    const end = endOf(view, { newestMs, oldestMs: -Infinity });
    const pixelMs = view.spanMs / box.value.width;
    const movedMs = Math.abs(end - shown.value.endMs);
    const waitMs = Math.min(MAX_WAIT_MS, Math.max(MIN_WAIT_MS, pixelMs));
    if (!isDirty && movedMs < STEP * pixelMs && movedMs < waitMs) {
      if (shown.value.newestMs !== newestMs && newestMs - wordsMs >= WORDS_MS) {
        write(plot.value, { ...shown.value, newestMs });
      }
      return;
    }
    draw(plot.value, scene, { startMs: end - view.spanMs, endMs: end, newestMs });
  });

  function draw(on: uPlot, stage: TimePlotScene, time: ShownTime): void {
    const isTimeForWords = isDirty || Math.abs(time.newestMs - wordsMs) >= WORDS_MS;
    isDirty = false;
    const { startMs, endMs } = time;
    const { view, endText, endMs: endOfAll } = source.value;
    stage.window = { startMs, endMs, width: box.value.width };
    stage.isFollowing = view.endMs === undefined;
    stage.endText = endText;
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
        on.setScale(scale, axis.follow(range, endOfAll === undefined ? endMs : nowMs()));
      }
    });
    shown.value = time;
    // uPlot draws in a microtask; positions are known afterwards.
    if (isTimeForWords) queueMicrotask(() => plot.value === on && write(on, time));
  }

  function write(on: uPlot, time: ShownTime): void {
    wordsMs = time.newestMs;
    const { lines } = source.value;
    const { width: boxWidth, height: boxHeight } = box.value;
    const { startMs, endMs } = time;
    const x = readingX.value;
    const readMs = x === undefined ? undefined : startMs + (x / boxWidth) * (endMs - startMs);
    const yOf = (line: PlotLine, value: number): number =>
      Number.isFinite(value) ? on.valToPos(value, line.scale) : 0;
    const readings = lines.map((line) =>
      readMs === undefined || !line.points ? undefined : pointAt(line.points, readMs, endMs),
    );
    const lasts = lines.map((line) => line.points && pointNear(line.points, endMs, endMs));
    const wanted = lines.map((line, i) => yOf(line, lasts[i]?.value ?? Number.NaN));
    const hasRoom = lines.length * LABEL_GAP <= boxHeight;
    const places = placeLabels(wanted, LABEL_GAP, boxHeight);
    words.value = {
      ends: hasRoom
        ? lines.flatMap(({ key, scale }, i) => {
            const last = lasts[i];
            if (!last) return [];
            return [{ key, y: places[i]!, text: formatFixed(last.value, decimalsOf(on, scale)) }];
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

/** Decimals for three significant digits of the axis' range. */
function decimalsOf({ scales }: uPlot, key: string): number {
  const { min = 0, max = 1 } = scales[key] ?? {};
  const span = (max ?? 1) - (min ?? 0);
  return Math.min(6, Math.max(0, 2 - Math.floor(Math.log10(span || 1))));
}
