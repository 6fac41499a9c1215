import { median } from '../statistics.ts';
import {
  compareWithReference,
  faultsOf,
  otherCpuOf,
  referenceOf,
  type WorkloadResult,
  type Comparison,
  type RunResult,
} from './results.ts';

/** Columns padded to their widest cell; cells that look like numbers go to the right. */
function formatTable(header: readonly string[], rows: readonly (readonly string[])[]): string {
  const all = [header, ...rows];
  const widths = header.map((_, column) =>
    Math.max(...all.map((row) => (row[column] ?? '').length)),
  );
  const isNumeric = header.map((_, column) =>
    rows.every((row) => /^$|^[-+<>=]*\s*[\d.]/.test(row[column] ?? '')),
  );
  return all
    .map((row) =>
      widths
        .map((width, column) =>
          isNumeric[column]
            ? (row[column] ?? '').padStart(width)
            : (row[column] ?? '').padEnd(width),
        )
        .join('  ')
        .trimEnd(),
    )
    .join('\n');
}

/** Three significant digits, thousands as k and M: 4.21 M, 183 k, 20.4, 0.59. */
function formatNumber(value: number): string {
  if (!Number.isFinite(value)) return '–';
  if (value >= 999_500) return `${(value / 1e6).toPrecision(3)} M`;
  if (value >= 9_995) return `${(value / 1e3).toPrecision(3)} k`;
  return value >= 1000 ? value.toFixed(0) : String(Number(value.toPrecision(3)));
}

const PREFIX = 'peers-';

/** Medians of all brokers as one table in Markdown; undefined when no workload was measured with peers. */
function formatPeers(workloads: readonly WorkloadResult[]): string | undefined {
  const measured = workloads.filter(({ name }) => name.startsWith(PREFIX));
  const names = Object.keys(measured[0]?.rounds ?? {});
  if (names.length === 0) return undefined;
  // The order of the first round: the reference first, then us.
  const sorted = [...names].sort((a, b) => rank(a) - rank(b));
  const rows = measured.flatMap(({ title, figures, rounds }) =>
    figures
      .filter(({ key }) => key !== 'loadCpu')
      .map(({ key, label, unit }) => {
        const values = sorted.map((name) => {
          const all = (rounds[name] ?? []).map((round) => round.figures[key]!);
          return all.length === 0 ? '' : formatNumber(median(all));
        });
        return [`${title}: ${label}, ${unit}`, ...values];
      }),
  );
  const line = (cells: readonly string[]): string => `| ${cells.join(' | ')} |`;
  return [
    line(['', ...sorted]),
    line(['---', ...sorted.map(() => '---:')]),
    ...rows.map(line),
  ].join('\n');
}

function rank(name: string): number {
  return ['raw-ws', 'ubii-extension', 'nats', 'mosquitto', 'aedes', 'socket.io'].indexOf(name);
}

/** Above this, in cores, other processes are part of what was measured. */
const BUSY_SHARE = 0.15;

/** The run as text: ratios first, then the values they come from, then what went wrong. */
export function formatRun(run: RunResult): string {
  const { machine, parameters, commit } = run;
  const sections = run.workloads.map((workload) => {
    const reference = referenceOf(workload);
    const rounds = workload.rounds[reference]?.length ?? 0;
    const header = ['', 'target', 'ratio', 'goal', '', 'rounds', 'median', reference, 'unit'];
    const table = formatTable(header, compareWithReference(workload).map(row));
    return [`${workload.title} (${rounds} rounds)`, table, ...notesOf(workload)].join('\n');
  });
  const peers = [formatPeers(run.workloads)].filter((table) => table !== undefined);
  const faults = faultsOf(run);
  const otherCpu = otherCpuOf(run);
  return [
    `Ratios to the last column but one in the same run, medians of rounds of ` +
      `${parameters.measureMs / 1000} s (commit ${commit.hash.slice(0, 9)}${commit.isDirty ? ' and changes' : ''}, ` +
      `Node ${machine.node}, ${machine.cores} cores, load ${machine.loadAverage.join(' -> ')})`,
    ...sections,
    ...peers,
    `Other processes used ${otherCpu.median.toFixed(2)} cores (median), at most ${otherCpu.max.toFixed(2)}.` +
      (otherCpu.median > BUSY_SHARE
        ? ' THE MACHINE WAS BUSY: the figures are partly about that.'
        : ''),
    faults.length === 0
      ? 'Everything arrived that was to arrive: once, in order, unaltered.'
      : `NOT EVERYTHING ARRIVED AS SENT, the figures do not count:\n${faults.map((fault) => `  ${fault}`).join('\n')}`,
  ].join('\n\n');
}

/** What the last round of each subject says. */
function notesOf({ rounds }: WorkloadResult): string[] {
  return Object.entries(rounds).flatMap(([name, all]) => {
    const notes = all.at(-1)?.notes ?? [];
    return notes.length === 0
      ? []
      : [`\n${name}, last round:`, ...notes.map((note) => `  ${note}`)];
  });
}

/** Empty where the reference has no such figure, or it is 0. */
function formatRatio(ratio: number): string {
  return Number.isFinite(ratio) ? ratio.toFixed(2) : '';
}

function row(comparison: Comparison): string[] {
  const { figure, target, ratio, range, goal, bound, isMet, value, reference } = comparison;
  const sign = figure.isHigherBetter ? '>=' : '<=';
  return [
    figure.label,
    target,
    formatRatio(ratio),
    goal !== undefined
      ? `${sign} ${goal}`
      : bound === undefined
        ? ''
        : `${sign} ${bound} ${figure.unit}`,
    isMet === undefined ? '' : isMet ? 'pass' : 'MISS',
    !Number.isFinite(ratio) ? '' : `${range[0].toFixed(2)} to ${range[1].toFixed(2)}`,
    formatNumber(value),
    formatNumber(reference),
    figure.unit,
  ];
}

/** Two runs side by side: what changed, and whether the rounds agree that it did. */
export function compareRuns(before: RunResult, after: RunResult): string {
  const header = ['workload', '', 'target', 'ratio before', 'ratio after', 'change', ''];
  const rows = after.workloads.flatMap((workload) => {
    const earlier = before.workloads.find(({ name }) => name === workload.name);
    if (earlier === undefined) return [];
    const old = compareWithReference(earlier);
    return compareWithReference(workload).flatMap((now) => {
      const then = old.find((c) => c.target === now.target && c.figure.key === now.figure.key);
      if (then === undefined || !Number.isFinite(now.ratio / then.ratio)) return [];
      const change = now.ratio / then.ratio - 1;
      const doOverlap = now.range[0] <= then.range[1] && then.range[0] <= now.range[1];
      return [
        [
          workload.name,
          now.figure.label,
          now.target,
          then.ratio.toFixed(2),
          now.ratio.toFixed(2),
          `${change >= 0 ? '+' : ''}${(change * 100).toFixed(1)} %`,
          doOverlap
            ? 'within the spread'
            : change > 0 === now.figure.isHigherBetter
              ? 'better'
              : 'worse',
        ],
      ];
    });
  });
  return [...differences(before, after), formatTable(header, rows)].join('\n');
}

function differences(before: RunResult, after: RunResult): string[] {
  const facts = (run: RunResult): Record<string, string | number | boolean> => ({
    Node: run.machine.node,
    cores: run.machine.cores,
    processor: run.machine.cpu,
    'placement on cores': run.machine.isPlaced,
    rounds: run.parameters.rounds,
    'measured ms': run.parameters.measureMs,
  });
  const then = facts(before);
  return Object.entries(facts(after))
    .filter(([name, value]) => value !== then[name])
    .map(([name, value]) => `Note: ${name} differs, ${then[name]} before and ${value} after.`);
}
