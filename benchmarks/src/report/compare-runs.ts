import { formatTable } from './format-table.ts';
import { compareWithReference, type RunResult } from './results.ts';

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
