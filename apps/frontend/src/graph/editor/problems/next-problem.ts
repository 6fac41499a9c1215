import type { ProblemRow } from './useProblemRows.ts';

/**
 * Returns the node with the next problem, in their order, from the beginning after the last one.
 * @param selected node that is selected now
 * @returns undefined when no problem has a node
 */
export function nextProblem(
  rows: readonly Pick<ProblemRow, 'node'>[],
  selected: string | undefined,
): string | undefined {
  const nodes = [...new Set(rows.flatMap(({ node }) => node ?? []))];
  const at = selected === undefined ? -1 : nodes.indexOf(selected);
  return nodes[(at + 1) % nodes.length];
}
