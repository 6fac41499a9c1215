import type uPlot from 'uplot';
import type { PlotTheme } from '../../ui/plot/plot-theme.ts';
import { formatNumber } from '../../ui/readouts/format-number.ts';
import type { PlotLine } from './plot-line.ts';
import { pointNear } from './read-plot.ts';
import type { PlotSizes } from './plot-sizes.ts';
import { colorOf, type SeriesLook } from './series-look.ts';
import { clockTicks, ticksBefore, type TimeTick } from './time-ticks.ts';
import type { TimeWindow } from './trace-options.ts';

/** State that the plot draws, updated in place before each frame. */
export interface TimePlotScene {
  readonly lines: readonly PlotLine[];
  readonly looks: readonly SeriesLook[];
  /** Keys of the value axes, innermost first. */
  readonly scales: readonly string[];
  /** Widths of the value axes, and of the labels at the ends of the lines, pixels. */
  readonly sizes: PlotSizes;
  window: TimeWindow;
  /** When the numbers of the page were read: lines end with the values that labels and legend say. */
  readMs: number;
  isFollowing: boolean;
  endText: string;
}

/** Sizes in pixels: height of the time axis, margin above the lines. */
export const BOTTOM = 26;
export const TOP = 18;

const LINE_WIDTH = 1.5;
/** Approximate distance of grid lines, pixels. */
const TICK_WIDTH = 120;
const CLOCK_TICK_WIDTH = 140;
/** Decimals of a tick; smaller ones have an exponent. */
const MAX_DECIMALS = 8;
/** Opacity of the held newest value. */
const HELD = 0.3;

/** Options for uPlot, which scales and draws axes; the lines draw themselves. */
export function timePlotOptions(
  scene: TimePlotScene,
  theme: PlotTheme,
  colorIn: (css: string) => string,
  size: { readonly width: number; readonly height: number },
): uPlot.Options {
  const { lines, looks, scales } = scene;
  const colors = looks.map((look) => colorIn(colorOf(look)));
  const axis = {
    font: theme.font,
    stroke: theme.color('--ink-3'),
    gap: 6,
    grid: { stroke: theme.color('--line-1'), width: 1 },
    ticks: { show: false },
  };
  const zero = theme.color('--line-2');
  return {
    ...size,
    padding: [TOP, () => scene.sizes.right, 0, 0],
    legend: { show: false },
    cursor: { show: false },
    scales: {
      x: { time: false, auto: false },
      ...Object.fromEntries(
        scales.map((key) => [
          key,
          { auto: false, range: (_plot: uPlot, min: number, max: number) => [min, max] },
        ]),
      ),
    } as uPlot.Scales,
    series: [
      {},
      ...lines.map((line, i): uPlot.Series => ({
        scale: line.scale,
        auto: false,
        stroke: colors[i]!,
        width: LINE_WIDTH,
        dash: [...looks[i]!.dash],
        points: { show: false },
        paths: (plot) => linePath(plot, line, scene),
      })),
    ],
    axes: [
      { ...axis, size: BOTTOM, ...timeAxis(scene) },
      ...scales.map((scale, i): uPlot.Axis => ({
        ...axis,
        scale,
        side: 3,
        size: (_plot, texts) => scene.sizes.axis(scale, texts),
        space: 44,
        grid: { ...axis.grid, show: i === 0 },
        values: (_plot, splits) => splits.map((value) => tickText(value, splits)),
      })),
      // Draw a value axis also without lines.
      ...(scales.length === 0
        ? [
            {
              ...axis,
              scale: 'y',
              side: 3 as const,
              size: scene.sizes.axis('y', []),
              values: () => [],
            },
          ]
        : []),
    ],
    hooks: {
      drawAxes: [(plot) => drawZero(plot, scales[0], zero)],
      draw: [(plot) => lines.forEach((line, i) => drawHeld(plot, line, scene, colors[i]!))],
    },
  };
}

function timeAxis(scene: TimePlotScene): Pick<uPlot.Axis, 'splits' | 'values'> {
  let ticks: readonly TimeTick[] = [];
  return {
    splits: () => {
      const { startMs, endMs, width } = scene.window;
      ticks = scene.isFollowing
        ? ticksBefore(startMs, endMs, width / TICK_WIDTH, scene.endText)
        : clockTicks(startMs, endMs, width / CLOCK_TICK_WIDTH);
      return ticks.map(({ timeMs }) => timeMs);
    },
    values: () => ticks.map(({ text }) => text),
  };
}

function linePath(
  plot: uPlot,
  line: PlotLine,
  { window: { startMs, endMs }, readMs }: TimePlotScene,
): uPlot.Series.Paths {
  const { left, width, top, height } = plot.bbox;
  const stroke = new Path2D();
  const { min = 0, max = 1 } = plot.scales[line.scale]!;
  const perUnit = height / ((max ?? 1) - (min ?? 0));
  const bottom = top + height;
  line.traced?.trace(
    {
      window: { startMs, endMs, width },
      toY: (value) => bottom - (value - (min ?? 0)) * perUnit,
      isStepped: line.isStepped,
    },
    {
      moveTo: (x, y) => stroke.moveTo(left + x, y),
      lineTo: (x, y) => stroke.lineTo(left + x, y),
    },
  );
  return {
    stroke,
    fill: null,
    clip: clipOf(plot, endOfLine(line, { startMs, endMs, readMs })),
    band: null,
    gaps: null,
    flags: 1,
  } as never;
}

/** Where the newest value that was read is, as a share of the width. */
function endOfLine(
  { points }: PlotLine,
  { startMs, endMs, readMs }: { startMs: number; endMs: number; readMs: number },
): number {
  if (readMs >= endMs) return 1;
  const last = points && pointNear(points, readMs, readMs);
  return last ? Math.max(0, (last.timeMs - startMs) / (endMs - startMs)) : 0;
}

/** @param share of the width that is drawn */
function clipOf({ bbox: { left, top, width, height } }: uPlot, share: number): Path2D {
  const clip = new Path2D();
  // Half of the line's width belongs to its last point.
  clip.rect(
    left,
    top,
    Math.min(width, share * width + (LINE_WIDTH / 2) * devicePixelRatio),
    height,
  );
  return clip;
}

function drawZero(plot: uPlot, scale: string | undefined, color: string): void {
  const { min, max } = (scale === undefined ? undefined : plot.scales[scale]) ?? {};
  if (scale === undefined || (min ?? 1) > 0 || (max ?? -1) < 0) return;
  const { ctx, bbox } = plot;
  const y = Math.round(plot.valToPos(0, scale, true)) + 0.5;
  ctx.save();
  ctx.strokeStyle = color;
  ctx.lineWidth = devicePixelRatio;
  ctx.beginPath();
  ctx.moveTo(bbox.left, y);
  ctx.lineTo(bbox.left + bbox.width, y);
  ctx.stroke();
  ctx.restore();
}

/** Extends the newest value to the right, where it holds until the next one. */
function drawHeld(
  plot: uPlot,
  line: PlotLine,
  { window, readMs }: TimePlotScene,
  color: string,
): void {
  const { startMs, endMs } = window;
  const lastMs = Math.min(endMs, readMs);
  const last = line.points && pointNear(line.points, lastMs, lastMs);
  if (!last || !Number.isFinite(last.value) || line.series.isDerivative) return;
  const { ctx, bbox } = plot;
  const fromMs = Math.max(startMs, last.timeMs);
  const x = bbox.left + ((fromMs - startMs) / (endMs - startMs)) * bbox.width;
  const y = plot.valToPos(last.value, line.scale, true);
  if (y < bbox.top || y > bbox.top + bbox.height) return;
  ctx.save();
  ctx.globalAlpha = HELD;
  ctx.strokeStyle = color;
  ctx.lineWidth = LINE_WIDTH * devicePixelRatio;
  ctx.beginPath();
  ctx.moveTo(x, y);
  ctx.lineTo(bbox.left + bbox.width, y);
  ctx.stroke();
  ctx.restore();
}

function tickText(value: number, splits: readonly number[]): string {
  const step = Math.abs((splits[1] ?? value + 1) - (splits[0] ?? value)) || 1;
  const decimals = decimalsOfStep(step);
  const shown = Math.abs(value) < step / 1e6 ? 0 : value;
  if (Math.abs(shown) >= 1e6) return shown.toPrecision(4).replaceAll('-', '−');
  if (decimals > MAX_DECIMALS) return shown.toExponential(1).replaceAll('-', '−');
  return formatNumber(shown, decimals);
}

/** Decimals that the step needs: 2.5 needs one, though it is larger than 1. */
function decimalsOfStep(step: number): number {
  for (let decimals = 0; decimals < 12; decimals++) {
    const scaled = step * 10 ** decimals;
    if (Math.abs(scaled - Math.round(scaled)) < 1e-6 * scaled) return decimals;
  }
  return 12;
}
