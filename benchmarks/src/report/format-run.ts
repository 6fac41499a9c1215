import { formatPeers } from './format-peers.ts';
import { formatNumber, formatTable } from './format-table.ts';
import {
  compareWithReference,
  faultsOf,
  otherCpuOf,
  referenceOf,
  type Comparison,
  type RunResult,
  type WorkloadResult,
} from './results.ts';

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
