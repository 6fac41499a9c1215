import { nodeTitle } from '../../canvas/node-label.ts';
import type { Graph } from '../../model/graph.ts';
import { openInput } from '../../model/open-input.ts';

/** Larger graphs are made by people who know what comes next. */
const MAX_NODES = 5;

/**
 * What comes next in a small graph until it can be started, in one line; undefined in larger ones.
 * @param byKeys the user worked with keys last: the line says which ones
 */
export function nextStep(graph: Graph, byKeys = false): string | undefined {
  const { nodes, wires } = graph;
  if (nodes.size === 0 || nodes.size > MAX_NODES) return undefined;
  const modules = [...nodes.values()].filter(({ kind }) => kind === 'module');
  const [first] = modules;
  if (first === undefined) {
    return byKeys ? 'Next: press A to add a module.' : 'Next: drag a module in.';
  }
  for (const module of modules) {
    const input = openInput(graph, module);
    if (input === undefined) continue;
    const title = nodeTitle(module);
    if (byKeys)
      return `Next: go to ${title} with the arrow keys, then press L to connect its input.`;
    const hasTopic = [...nodes.values()].some(({ kind }) => kind === 'topic');
    return hasTopic
      ? `Next: pull a wire from the topic to the input “${input.name}” of ${title}.`
      : `Next: drag a topic onto the input “${input.name}” of ${title}.`;
  }
  if (![...wires.values()].some(({ from }) => nodes.get(from.node)?.kind === 'module')) {
    return byKeys
      ? `Next: go to ${nodeTitle(first)} with the arrow keys, then press L to connect its output.`
      : 'Next: pull the output of the module to an empty place.';
  }
  return byKeys ? 'Next: press Ctrl Enter to start.' : 'Next: press Start.';
}
