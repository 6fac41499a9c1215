import type { Graph } from '../../model/graph.ts';

/** Larger graphs are made by people who know what comes next. */
const MAX_NODES = 5;

/** What comes next in a small graph until it can be started, in one line; undefined in larger ones. */
export function nextStep({ nodes, wires }: Graph): string | undefined {
  if (nodes.size === 0 || nodes.size > MAX_NODES) return undefined;
  const isModule = (id: string): boolean => nodes.get(id)?.kind === 'module';
  const all = [...wires.values()];
  const modules = [...nodes.values()].filter(({ kind }) => kind === 'module');
  // Inputs with a default may stay as they are.
  const takes = modules.some(({ ports }) =>
    ports.some(({ direction, defaultJson }) => direction === 'in' && defaultJson === undefined),
  );
  if (modules.length === 0) return 'Next: drag a module in.';
  if (takes && !all.some(({ to }) => isModule(to.node))) {
    return [...nodes.values()].some(({ kind }) => kind === 'topic')
      ? 'Next: pull a wire from the topic to an input of the module (keyboard: L).'
      : 'Next: drag a topic onto an input of the module (keyboard: L).';
  }
  if (!all.some(({ from }) => isModule(from.node)))
    return 'Next: pull the output of the module to an empty place (keyboard: L).';
  return 'Next: press Start.';
}
