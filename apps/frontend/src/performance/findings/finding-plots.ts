import { binStartMs } from '../measure/histogram.ts';
import type { Curve, Findings, Histogram } from '../measure/findings.ts';
import { formatAxisNumber } from '../../ui/plot/axis-numbers.ts';
import { plotStroke, type PlotChart } from '../../ui/plot/plot-chart.ts';

/** A chart with its texts. */
export interface FindingPlot {
  readonly key: string;
  readonly title: string;
  readonly summary: string;
  readonly chart: PlotChart;
}

/** A run in a chart of several. */
export interface PlottedRun {
  readonly name: string;
  readonly findings: Findings;
}

/** Returns the charts of one or several runs; charts of the same key are overlaid. */
export function findingPlots(runs: readonly PlottedRun[]): FindingPlot[] {
  const keysOf = (list: (findings: Findings) => readonly { readonly key: string }[]) => [
    ...new Set(runs.flatMap(({ findings }) => list(findings).map(({ key }) => key))),
  ];
  return [
    ...keysOf(({ histograms }) => histograms).map((key) =>
      histogramPlot(
        runs.flatMap(({ name, findings }) => {
          const histogram = findings.histograms.find((one) => one.key === key);
          return histogram ? [{ name, histogram }] : [];
        }),
      ),
    ),
    ...keysOf(({ curves }) => curves).map((key) =>
      curvePlot(
        runs.flatMap(({ name, findings }) => {
          const curve = findings.curves.find((one) => one.key === key);
          return curve ? [{ name, curve }] : [];
        }),
      ),
    ),
  ];
}

/** Uses percentages, so that runs of different lengths are comparable. */
function histogramPlot(
  runs: readonly { readonly name: string; readonly histogram: Histogram }[],
): FindingPlot {
  const [{ histogram: first }] = runs as [(typeof runs)[number]];
  const from = Math.min(...runs.map(({ histogram }) => histogram.firstBin));
  const to = Math.max(
    ...runs.map(({ histogram }) => histogram.firstBin + histogram.counts.length - 1),
  );
  // An empty bin at each side, so that the steps start and end at zero.
  const bins = Array.from({ length: to - from + 3 }, (_, index) => from - 1 + index);
  const isAlone = runs.length === 1;
  const summaries: string[] = [];
  const lines = runs.map(({ name, histogram }, index) => {
    const total = histogram.counts.reduce((sum, count) => sum + count, 0);
    const share = (bin: number): number =>
      ((histogram.counts[bin - histogram.firstBin] ?? 0) / total) * 100;
    const values = bins.map(share);
    const top = bins[values.indexOf(Math.max(...values))]!;
    const range = `between ${edge(top)} and ${edge(top + 1)} ms`;
    summaries.push(
      isAlone ? `Most often ${range}, of ${total} values.` : `${name}: most often ${range}.`,
    );
    return { label: name, values, kind: 'steps' as const, stroke: plotStroke(index) };
  });
  return {
    key: `histogram ${first.key}`,
    title: first.title,
    summary: summaries.join(' '),
    chart: {
      x: bins.map(binStartMs),
      lines,
      xAxis: { label: 'Duration', unit: 'ms', isLogarithmic: true },
      yAxis: { label: 'Share', unit: '%' },
    },
  };
}

/** The first bin includes durations below the resolution. */
const edge = (bin: number): string => (bin === 0 ? '0' : formatAxisNumber(binStartMs(bin)));

function curvePlot(runs: readonly { readonly name: string; readonly curve: Curve }[]): FindingPlot {
  const [{ curve: first }] = runs as [(typeof runs)[number]];
  const x = [...new Set(runs.flatMap(({ curve }) => curve.x.values))].sort((a, b) => a - b);
  let drawn = 0;
  const lines = runs.flatMap(({ name, curve }) =>
    curve.lines.map(({ label, values }) => {
      const byX = new Map(curve.x.values.map((at, index) => [at, values[index] ?? null]));
      return {
        label: runs.length === 1 ? label : `${name}: ${label}`,
        values: runs.length === 1 ? values : joined(x, byX),
        kind: x.length <= MAX_POINTS_DRAWN ? ('both' as const) : ('line' as const),
        stroke: plotStroke(drawn++),
      };
    }),
  );
  return {
    key: `curve ${first.key}`,
    title: first.title,
    summary: runs
      .map(({ name, curve }) => curveSummary(curve, runs.length > 1 ? name : ''))
      .join(' '),
    chart: {
      x,
      lines,
      xAxis: {
        label: first.x.label,
        unit: first.x.unit,
        ...(first.isLogarithmic ? { isLogarithmic: true } : {}),
      },
      yAxis: { label: first.y.label, unit: first.y.unit },
      ...(runs.length === 1 && first.mark ? { marks: [first.mark] } : {}),
    },
  };
}

/** Most points that are drawn individually; a line between few points says less. */
const MAX_POINTS_DRAWN = 30;

/** Returns values at all x of all runs: interpolated between points of a run, none outside. */
function joined(x: readonly number[], byX: ReadonlyMap<number, number | null>): (number | null)[] {
  const own = [...byX.keys()].sort((a, b) => a - b);
  return x.map((at) => {
    const exact = byX.get(at);
    if (exact !== undefined) return exact;
    const after = own.findIndex((one) => one > at);
    if (after <= 0) return null;
    const [x0, x1] = [own[after - 1]!, own[after]!];
    const [y0, y1] = [byX.get(x0) ?? null, byX.get(x1) ?? null];
    if (y0 === null || y1 === null) return null;
    return y0 + ((y1 - y0) * (at - x0)) / (x1 - x0);
  });
}

function curveSummary({ lines, y, mark, x }: Curve, name: string): string {
  const parts = lines.flatMap(({ label, values }) => {
    const there = values.filter((value) => value !== null);
    if (there.length === 0) return [];
    const [low, high] = [Math.min(...there), Math.max(...there)].map(formatAxisNumber);
    const range = low === high ? `${low}` : `${low} to ${high}`;
    return [`${label} ${range}${y.unit ? ` ${y.unit}` : ''}`];
  });
  const at = mark
    ? `; ${mark.text} at ${formatAxisNumber(mark.x)}${x.unit ? ` ${x.unit}` : ''}`
    : '';
  return `${name === '' ? '' : `${name}: `}${parts.join(', ')}${at}.`;
}
