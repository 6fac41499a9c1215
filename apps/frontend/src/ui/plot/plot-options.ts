import type uPlot from 'uplot';
import { formatAxisNumber } from './axis-numbers.ts';
import type { PlotAxis, PlotChart, PlotLine } from './plot-chart.ts';
import type { PlotTheme } from './plot-theme.ts';

const LINE_WIDTH = 1.5;
const AXIS_WIDTH = 52;
const AXIS_HEIGHT = 44;
const POINT_SIZE = 6;
const STEP_OF_LOG = [1, 2, 5];

/** Options of uPlot for a chart and a theme. */
export function plotOptions(
  library: typeof uPlot,
  chart: PlotChart,
  theme: PlotTheme,
  size: { readonly width: number; readonly height: number },
): uPlot.Options {
  const { xAxis, yAxis, lines } = chart;
  return {
    ...size,
    padding: [12, 16, 0, 0],
    legend: { show: false },
    cursor: {
      drag: { x: false, y: false },
      y: false,
      points: { size: POINT_SIZE + 2 },
    },
    scales: {
      x: { time: false, ...scaleOf(xAxis, false) },
      y: scaleOf(yAxis, true),
    },
    series: [{}, ...lines.map((line) => seriesOf(library, line, theme))],
    axes: [axisOf(xAxis, theme, AXIS_HEIGHT), axisOf(yAxis, theme, AXIS_WIDTH)],
    hooks: { drawClear: [], draw: [(plot) => drawMarks(plot, chart, theme)] },
  };
}

function scaleOf(
  { isLogarithmic = false, fromZero }: PlotAxis,
  isY: boolean,
): Partial<uPlot.Scale> {
  if (isLogarithmic) {
    return {
      distr: 3,
      log: 10,
      range: (_plot, min, max) => (max > min ? [min, max] : [min / 2, max * 2]),
    };
  }
  if (!(fromZero ?? isY)) return {};
  return {
    range: (_plot, _min, max) => [0, max > 0 ? max * 1.08 : 1],
  };
}

function seriesOf(library: typeof uPlot, line: PlotLine, theme: PlotTheme): uPlot.Series {
  const { kind = 'line', stroke } = line;
  const color = theme.color(stroke?.color ?? '--ink-1');
  return {
    label: line.label,
    stroke: color,
    width: LINE_WIDTH,
    ...(stroke?.dash ? { dash: [...stroke.dash] } : {}),
    ...(kind === 'steps' ? { paths: library.paths.stepped!({ align: 1 }) } : {}),
    ...(kind === 'points' ? { paths: () => null } : {}),
    points: {
      show: kind === 'points' || kind === 'both',
      size: POINT_SIZE,
      fill: color,
      stroke: color,
    },
    spanGaps: false,
  };
}

function axisOf(axis: PlotAxis, theme: PlotTheme, size: number): uPlot.Axis {
  const format = axis.format ?? formatAxisNumber;
  const unit = axis.unit ? `, ${axis.unit}` : '';
  return {
    label: `${axis.label}${unit}`,
    labelFont: theme.labelFont,
    labelSize: 18,
    labelGap: 2,
    font: theme.font,
    stroke: theme.color('--ink-3'),
    size: size - 18,
    gap: 4,
    grid: { stroke: theme.color('--line-1'), width: 1 },
    ticks: { show: false },
    ...(axis.isLogarithmic ? { filter: (_plot: uPlot, splits: number[]) => splits } : {}),
    values: (_plot, splits) =>
      splits.map((value) => {
        if (value === null || value === undefined) return '';
        return axis.isLogarithmic && !isLabelled(value) ? '' : format(value);
      }),
  };
}

/** Labels 1, 2 and 5 of each decade: more would overlap. */
function isLabelled(value: number): boolean {
  const digit = value / 10 ** Math.floor(Math.log10(value) + 1e-9);
  return STEP_OF_LOG.some((step) => Math.abs(digit - step) < 1e-6);
}

function drawMarks(plot: uPlot, { marks = [] }: PlotChart, theme: PlotTheme): void {
  const { ctx, bbox } = plot;
  const ratio = bbox.width / plot.over.clientWidth || 1;
  ctx.save();
  ctx.strokeStyle = theme.color('--ink-2');
  ctx.fillStyle = theme.color('--ink-2');
  ctx.lineWidth = ratio;
  ctx.font = theme.labelFont.replace('11px', `${11 * ratio}px`);
  for (const { x, text } of marks) {
    const at = Math.round(plot.valToPos(x, 'x', true)) + 0.5;
    if (at < bbox.left || at > bbox.left + bbox.width) continue;
    ctx.beginPath();
    ctx.moveTo(at, bbox.top);
    ctx.lineTo(at, bbox.top + bbox.height);
    ctx.stroke();
    const isRight = at > bbox.left + bbox.width / 2;
    ctx.textAlign = isRight ? 'right' : 'left';
    ctx.fillText(text, at + (isRight ? -6 : 6) * ratio, bbox.top + 10 * ratio);
  }
  ctx.restore();
}
