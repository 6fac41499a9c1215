import type { ModuleStatistics } from '@ubii/proto';

/** Runs without an output after which a module counts as silent. */
const MIN_RUNS = 10;

/** Whether a module with connected outputs ran several times and never output anything. */
export const isSilent = (
  statistics: Pick<ModuleStatistics, 'runs' | 'outputs'> | undefined,
  wires: { readonly out: readonly unknown[] },
): boolean =>
  statistics !== undefined &&
  statistics.runs >= MIN_RUNS &&
  statistics.outputs === 0 &&
  wires.out.length > 0;
