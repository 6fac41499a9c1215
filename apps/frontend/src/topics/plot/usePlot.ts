import type { DataFormatFamily } from '@ubii/proto';
import { useElementSize, usePreferredContrast, useRafFn } from '@vueuse/core';
import { computed, shallowRef, watch, type ComputedRef, type Ref, type ShallowRef } from 'vue';
import { useIsDark } from '../../theme/useTheme.ts';
import type { TopicHistory } from '../history/topic-history.ts';
import { nowMs } from '../history/useTopicHistory.ts';
import { formatFixed } from '../values/format-value.ts';
import { drawPlot, toY, type PlotColors } from './draw-plot.ts';
import { placeLabels } from './place-labels.ts';
import { pointAt, pointNear, valuesWithin, type PlotPoint } from './read-plot.ts';
import { ticksOf, ValueAxis, type Range, type Tick } from './value-axis.ts';

/** What is drawn. */
export interface PlotSource {
  readonly history: TopicHistory;
  readonly windowMs: number;
  /** Stands still at this moment, this machine's clock; `undefined` while it runs. */
  readonly frozenMs: number | undefined;
  /** Vertical lines of the grid, both edges included. */
  readonly columns: number;
  readonly isStepped: boolean;
  readonly family: DataFormatFamily;
}

/** What it is drawn on. */
export interface PlotElements {
  readonly frame: Readonly<Ref<HTMLElement | null>>;
  readonly canvas: Readonly<Ref<HTMLCanvasElement | null>>;
  /** Carries the theme's colours. */
  readonly swatch: Readonly<Ref<HTMLElement | null>>;
}

/** The words around the lines, with pixels from the top of the plot. */
export interface PlotWords {
  readonly ticks: readonly { readonly y: number; readonly text: string }[];
  readonly ends: readonly { readonly y: number; readonly name: string; readonly text: string }[];
}

/** What the lines say where the reading line stands. */
export interface PlotReading {
  readonly point: PlotPoint;
  readonly agoMs: number;
}

/** Pixels around the plot: values left, names right, time below. */
export const PLOT_LEFT = 46;
const RIGHT = 92;
const NARROW_RIGHT = 68;
const BOTTOM = 26;
/** Below this width names and values stand closer. */
const NARROW = 480;
/** A frame is drawn when the lines have moved this far, pixels, */
const STEP = 1.5;
/** or after this long, milliseconds. */
const MAX_WAIT_MS = 50;
/** Words are renewed this often, milliseconds: as fast as digits can be read. */
const WORDS_MS = 125;
/** Between the names of two lines, pixels. */
const LABEL_GAP = 17;
/** Between two lines of the grid, pixels, about. */
const TICK_GAP = 70;

/** Draws the lines of a topic frame by frame, and says what to write around them. */
export function usePlot(
  source: Readonly<Ref<PlotSource>>,
  { frame, canvas, swatch }: PlotElements,
): {
  /** Of the plot without the words around it, pixels. */
  width: ComputedRef<number>;
  height: ComputedRef<number>;
  right: ComputedRef<number>;
  words: Readonly<ShallowRef<PlotWords>>;
  /** Where the reading line stands, pixels from the left; `undefined` for nowhere. */
  cursorX: ShallowRef<number | undefined>;
  reading: Readonly<ShallowRef<PlotReading | undefined>>;
} {
  const { width: fullWidth, height: fullHeight } = useElementSize(frame);
  const right = computed(() => (fullWidth.value < NARROW ? NARROW_RIGHT : RIGHT));
  const width = computed(() => Math.max(0, Math.round(fullWidth.value - PLOT_LEFT - right.value)));
  const height = computed(() => Math.max(0, Math.round(fullHeight.value - BOTTOM)));
  const words = shallowRef<PlotWords>({ ticks: [], ends: [] });
  const reading = shallowRef<PlotReading>();
  const cursorX = shallowRef<number>();

  let axis = new ValueAxis();
  let colors: PlotColors | undefined;
  let drawnMs = 0;
  let wordsMs = 0;
  let isDirty = true;
  watch(
    () => source.value.history,
    () => {
      axis = new ValueAxis();
      cursorX.value = undefined;
    },
  );
  watch([source, width, height, cursorX], () => (isDirty = true));
  // Asking the browser for a colour makes it work out all styles, so it is asked only after a change.
  const [isDark, contrast] = [useIsDark(), usePreferredContrast()];
  watch(
    [() => source.value.family, isDark, contrast],
    () => {
      colors = undefined;
      isDirty = true;
    },
    { flush: 'post' },
  );

  useRafFn(() => {
    const { frozenMs, windowMs } = source.value;
    const endMs = frozenMs ?? nowMs();
    const moved = ((endMs - drawnMs) / windowMs) * width.value;
    if (width.value === 0 || height.value === 0) return;
    const isWaiting = frozenMs === undefined && endMs - drawnMs >= MAX_WAIT_MS;
    if (!isDirty && !isWaiting && Math.abs(moved) < STEP) return;
    drawnMs = endMs;
    const isTimeForWords = isDirty || Math.abs(endMs - wordsMs) >= WORDS_MS;
    isDirty = false;
    draw(endMs, isTimeForWords);
  });

  function draw(endMs: number, withWords: boolean): void {
    const { history, windowMs, columns, isStepped } = source.value;
    const context = canvas.value && fitCanvas(canvas.value, width.value, height.value);
    const ring = history.points;
    if (!context || !ring || !swatch.value) return;
    const startMs = endMs - windowMs;
    const range = axis.follow(valuesWithin(ring, startMs, endMs), endMs);
    const ticks = ticksOf(range, Math.max(2, height.value / TICK_GAP));
    colors ??= readColors(swatch.value);
    const x = cursorX.value;
    const cursorMs = x === undefined ? undefined : startMs + (x / width.value) * windowMs;
    const point = cursorMs === undefined ? undefined : pointAt(ring, cursorMs, endMs);
    drawPlot(context, {
      ring,
      window: { startMs, endMs, width: width.value },
      height: height.value,
      range,
      ticks,
      columns,
      isStepped,
      colors,
      cursor: point && x !== undefined ? { x, values: point.values } : undefined,
    });
    if (!withWords) return;
    wordsMs = endMs;
    reading.value = point && { point, agoMs: endMs - point.timeMs };
    words.value = {
      ticks: tickWords(ticks, range, height.value),
      ends: endWords(history, ticks, range, height.value, endMs),
    };
  }

  return { width, height, right, words, cursorX, reading };
}

function tickWords(ticks: readonly Tick[], range: Range, height: number): PlotWords['ticks'] {
  return ticks.map(({ value, decimals }) => ({
    y: toY(range, height, value),
    text: formatFixed(Math.abs(value) < 1e-12 ? 0 : value, decimals),
  }));
}

function endWords(
  { points, series }: TopicHistory,
  ticks: readonly Tick[],
  range: Range,
  height: number,
  endMs: number,
): PlotWords['ends'] {
  const last = points && pointNear(points, endMs, endMs);
  if (!last) return [];
  // Two digits more than the grid needs
  const decimals = Math.min(6, (ticks[0]?.decimals ?? 0) + 2);
  const wanted = last.values.map((value) =>
    Number.isFinite(value) ? toY(range, height, value) : 0,
  );
  return placeLabels(wanted, LABEL_GAP, height).map((y, line) => ({
    y,
    name: series?.names[line] ?? '',
    text: formatFixed(last.values[line] ?? Number.NaN, decimals),
  }));
}

/** The canvas in device pixels, drawn on in CSS pixels. */
function fitCanvas(
  element: HTMLCanvasElement,
  width: number,
  height: number,
): CanvasRenderingContext2D | null {
  const ratio = window.devicePixelRatio;
  const deviceWidth = Math.round(width * ratio);
  const deviceHeight = Math.round(height * ratio);
  if (element.width !== deviceWidth) element.width = deviceWidth;
  if (element.height !== deviceHeight) element.height = deviceHeight;
  const context = element.getContext('2d');
  context?.setTransform(ratio, 0, 0, ratio, 0, 0);
  return context;
}

/** The theme's colours, resolved by the browser. */
function readColors(swatch: HTMLElement): PlotColors {
  const style = getComputedStyle(swatch);
  return {
    line: style.color,
    ink: style.outlineColor,
    grid: style.borderTopColor,
    zero: style.borderBottomColor,
    ground: style.backgroundColor,
  };
}
