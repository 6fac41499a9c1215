import { nodeTitle } from '../../nodes/node-label.ts';
import type { Graph, GraphNode, Port } from '../../model/graph.ts';
import { openInput } from '../../model/open-input.ts';

/** Largest graph with hints; users with larger ones know the next step. */
const MAX_NODES = 5;

/** Input method: pointer or keyboard on the canvas, or the list. */
export type Way = 'pointer' | 'keys' | 'list';

interface Steps {
  readonly module: string;
  input(title: string, input: Port, hasTopic: boolean): string;
  output(title: string, output: Port | undefined): string;
  readonly start: string;
}

const STEPS: Readonly<Record<Way, Steps>> = {
  pointer: {
    module: 'drag a module in.',
    input: (title, { name }, hasTopic) =>
      hasTopic
        ? `pull a wire from the topic to the input “${name}” of ${title}.`
        : `drag a topic onto the input “${name}” of ${title}.`,
    output: () => 'pull the output of the module to an empty place.',
    start: 'press Start.',
  },
  keys: {
    module: 'press A to add a module.',
    input: (title) => `go to ${title} with the arrow keys, then press L to connect its input.`,
    output: (title) => `go to ${title} with the arrow keys, then press L to connect its output.`,
    start: 'press Ctrl Enter to start.',
  },
  list: {
    module: 'press Add, and choose a module.',
    input: (title, { name }) => `press the input “${name}” of ${title}, and choose its topic.`,
    output: (title, output) =>
      output === undefined
        ? 'press an output, and choose a topic.'
        : `press the output “${output.name}” of ${title}, and choose a topic.`,
    start: 'press Start.',
  },
};

/** Returns the next step for a small graph until it can be started, in one line; undefined for larger graphs. */
export function nextStep(graph: Graph, way: Way = 'pointer'): string | undefined {
  const { nodes, wires } = graph;
  if (nodes.size === 0 || nodes.size > MAX_NODES) return undefined;
  const steps = STEPS[way];
  const all = [...nodes.values()];
  const modules = all.filter(({ kind }) => kind === 'module');
  const [first] = modules;
  if (first === undefined) return `Next: ${steps.module}`;
  for (const module of modules) {
    const input = openInput(graph, module);
    if (input === undefined) continue;
    const hasTopic = all.some(({ kind }) => kind === 'topic');
    return `Next: ${steps.input(nodeTitle(module), input, hasTopic)}`;
  }
  if (![...wires.values()].some(({ from }) => nodes.get(from.node)?.kind === 'module'))
    return `Next: ${steps.output(nodeTitle(first), firstOutput(first))}`;
  return `Next: ${steps.start}`;
}

const firstOutput = ({ ports }: GraphNode): Port | undefined =>
  ports.find(({ direction }) => direction === 'out');
