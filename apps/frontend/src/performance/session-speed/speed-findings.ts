import type { ModuleStatistics, SessionStatistics } from '@ubii/proto';
import { durationFigure, durationFigures } from '../measure/duration-figures.ts';
import { median, type Durations } from '../measure/durations.ts';
import type { Curve, Figure, Findings, Histogram } from '../measure/findings.ts';
import { histogramOf } from '../measure/histogram.ts';
import type { SpeedParameters } from './speed-parameters.ts';

/** Data collected while the modules ran. */
export interface SpeedRecord {
  readonly reports: readonly SessionStatistics[];
  readonly durations: Durations;
  readonly echoes: Durations;
  /** Time from the request until all modules ran, milliseconds. */
  readonly startMs: number;
  readonly startedMs: number;
}

/** Share of missing runs from which a note is shown. */
const MISSED_SHARE = 0.05;

export function speedFindings(parameters: SpeedParameters, record: SpeedRecord): Findings {
  const { reports, durations, echoes, startMs } = record;
  const histogram = (key: string, title: string, of: Durations): Histogram[] => {
    const one = histogramOf(key, title, of.values);
    return one ? [one] : [];
  };
  return {
    figures: [
      ...runFigures(parameters, reports),
      ...durationFigures('work', 'Work', durations.summary()).slice(0, 2),
      ...durationFigures('echo', 'Input to output', echoes.summary()).slice(0, 3),
      durationFigure('start', 'Start', startMs),
    ],
    histograms: [
      ...histogram('echo', 'From input to output', echoes),
      ...histogram('work', 'Computing time of one run', durations),
    ],
    curves: curvesOf(reports),
    notes: notesOf(parameters, reports),
  };
}

const sum = (modules: readonly ModuleStatistics[], of: (one: ModuleStatistics) => number): number =>
  modules.reduce((total, one) => total + of(one), 0);
const worst = ({ modules }: SessionStatistics, of: (one: ModuleStatistics) => number): number =>
  Math.max(0, ...modules.map(of));
const runsOf = ({ modules }: SessionStatistics): number =>
  sum(modules, ({ runsPerSecond }) => runsPerSecond);

/** Runs per second from the counters of the first and last report: medians would hide pauses. */
function runRate(reports: readonly SessionStatistics[]): number | undefined {
  const [first, last] = [reports[0], reports.at(-1)];
  if (first === undefined || last === undefined) return undefined;
  const seconds = (last.timeMs - first.timeMs) / 1000;
  if (seconds <= 0) return runsOf(last);
  const runs = ({ modules }: SessionStatistics): number => sum(modules, (one) => one.runs);
  return (runs(last) - runs(first)) / seconds;
}

function runFigures(
  { iterations, instances }: SpeedParameters,
  reports: readonly SessionStatistics[],
): Figure[] {
  const rate = runRate(reports);
  const last = reports.at(-1);
  if (rate === undefined || last === undefined) return [];
  const first = reports[0]!;
  const gained = (of: (one: ModuleStatistics) => number): number =>
    Math.max(0, sum(last.modules, of) - sum(first.modules, of));
  const more = { better: 'more' as const };
  const passes = reports.filter(({ passesPerSecond }) => passesPerSecond > 0);
  const middle = (of: (one: SessionStatistics) => number): number => median(reports.map(of)) ?? 0;
  return [
    { key: 'runs', label: 'Runs of all modules', value: rate, unit: '/s', decimals: 1, ...more },
    {
      key: 'runs.each',
      label: 'Runs of each module',
      value: rate / instances,
      unit: '/s',
      decimals: 1,
      ...more,
    },
    {
      key: 'additions',
      label: 'Additions',
      value: (rate * iterations) / 1e6,
      unit: 'M/s',
      decimals: 2,
      ...more,
    },
    durationFigure(
      'run.p50',
      'Run p50',
      middle((one) => worst(one, ({ runP50Ms }) => runP50Ms)),
    ),
    durationFigure(
      'run.p95',
      'Run p95',
      middle((one) => worst(one, ({ runP95Ms }) => runP95Ms)),
    ),
    ...(passes.length > 0
      ? [
          durationFigure('pass.p50', 'Pass p50', median(passes.map((one) => one.passP50Ms))!),
          durationFigure('pass.p95', 'Pass p95', median(passes.map((one) => one.passP95Ms))!),
        ]
      : []),
    {
      key: 'overruns',
      label: 'Late runs',
      value: gained(({ overruns }) => overruns),
      unit: '',
      better: 'less',
    },
    {
      key: 'errors',
      label: 'Failed runs',
      value: gained(({ errors }) => errors),
      unit: '',
      better: 'less',
    },
  ];
}

function curvesOf(reports: readonly SessionStatistics[]): Curve[] {
  const first = reports[0];
  if (first === undefined) return [];
  const x = {
    label: 'Time',
    unit: 's',
    values: reports.map(({ timeMs }) => (timeMs - first.timeMs) / 1000),
  };
  const line = (key: string, label: string, of: (one: SessionStatistics) => number) => ({
    key,
    label,
    values: reports.map(of),
  });
  return [
    {
      key: 'runs',
      title: 'Runs over time',
      x,
      y: { label: 'Runs per second', unit: '/s' },
      lines: [line('runs', 'All modules', runsOf)],
    },
    {
      key: 'run',
      title: 'Run time over time',
      x,
      y: { label: 'Run time', unit: 'ms' },
      lines: [
        line('p50', 'p50', (one) => worst(one, ({ runP50Ms }) => runP50Ms)),
        line('p95', 'p95', (one) => worst(one, ({ runP95Ms }) => runP95Ms)),
      ],
    },
  ];
}

function notesOf(
  { mode, hertz, instances }: SpeedParameters,
  reports: readonly SessionStatistics[],
): string[] {
  const rate = runRate(reports);
  if (rate === undefined) return ['The session has reported no statistics.'];
  const notes: string[] = [];
  const wanted = hertz * instances;
  if (mode === 'frequency' && rate < (1 - MISSED_SHARE) * wanted) {
    notes.push(
      `The modules should run ${wanted} times per second together and ran ${rate.toFixed(0)} times: the node cannot keep this frequency with this work.`,
    );
  }
  const failed = reports.at(-1)!.modules.some(({ errors, restarts }) => errors + restarts > 0);
  if (failed) notes.push('Runs failed or modules were stopped: the figures are not valid.');
  return notes;
}
