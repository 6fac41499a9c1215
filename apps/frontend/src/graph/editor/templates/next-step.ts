import { nodeTitle } from '../../nodes/node-label.ts';
import { connectables } from '../../canvas/connectable.ts';
import type { Graph, GraphNode, Port, PortRef } from '../../model/graph.ts';
import { openInput } from '../../model/open-input.ts';
import { portOf } from '../../model/port-format.ts';

/** Largest graph with hints; users with larger ones know the next step. */
const MAX_NODES = 5;

/** Input method: pointer or keyboard on the canvas, or the list. */
export type Way = 'pointer' | 'keys' | 'list';

interface Steps {
  readonly module: string;
  /** @param from an output that fits the input, if there is one */
  input(title: string, input: Port, hasTopic: boolean, from: string | undefined): string;
  output(title: string, output: Port | undefined): string;
  /** @param button text of the button that starts */
  start(button: string): string;
}

const STEPS: Readonly<Record<Way, Steps>> = {
  pointer: {
    module: 'drag a module in.',
    input(title, { name }, hasTopic, from) {
      const to = `the input “${name}” of ${title}`;
      if (hasTopic) return `pull a wire from the topic to ${to}.`;
      return from === undefined ? `drag a topic onto ${to}.` : `pull a wire from ${from} to ${to}.`;
    },
    output: () => 'pull the output of the module to an empty place.',
    start: (button) => `press ${button}.`,
  },
  keys: {
    module: 'press A to add a module.',
    input: (title) => `go to ${title} with the arrow keys, then press L to connect its input.`,
    output: (title) => `go to ${title} with the arrow keys, then press L to connect its output.`,
    start: () => 'press Ctrl Enter to start.',
  },
  list: {
    module: 'press Add, and choose a module.',
    input: (title, { name }) => `press the input “${name}” of ${title}, and choose its topic.`,
    output: (title, output) =>
      output === undefined
        ? 'press an output, and choose a topic.'
        : `press the output “${output.name}” of ${title}, and choose a topic.`,
    start: (button) => `press ${button}.`,
  },
};

/**
 * Returns the next step for a small graph until it can be started, in one line; undefined for larger graphs.
 * @param button text of the button that starts the session
 */
export function nextStep(graph: Graph, way: Way = 'pointer', button = 'Start'): string | undefined {
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
    const from = hasTopic ? undefined : fittingOutput(graph, { node: module.id, port: input.id });
    return `Next: ${steps.input(nodeTitle(module), input, hasTopic, from)}`;
  }
  if (![...wires.values()].some(({ from }) => nodes.get(from.node)?.kind === 'module'))
    return `Next: ${steps.output(nodeTitle(first), firstOutput(first))}`;
  return `Next: ${steps.start(button)}`;
}

/** `“sine” of clock`: the output of another module that fits an input best. */
function fittingOutput(graph: Graph, input: PortRef): string | undefined {
  for (const { isLoop, port } of connectables(graph, input, '', [], () => undefined)) {
    const node = port && graph.nodes.get(port.node);
    if (isLoop || node?.kind !== 'module') continue;
    return `“${portOf(graph, port!)?.name ?? ''}” of ${nodeTitle(node)}`;
  }
  return undefined;
}

const firstOutput = ({ ports }: GraphNode): Port | undefined =>
  ports.find(({ direction }) => direction === 'out');
