import { median } from '../statistics.ts';
import { formatNumber } from './format-table.ts';
import type { WorkloadResult } from './results.ts';

const PREFIX = 'peers-';

/** Medians of all brokers as one table in Markdown; undefined when no workload was measured with peers. */
export function formatPeers(workloads: readonly WorkloadResult[]): string | undefined {
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
