import { formatsFit } from '@ubii/pm-sandbox';
import type { Graph, ModuleNode, Port } from '../graph.ts';
import { openInput } from '../open-input.ts';
import { inputPort } from '../ports.ts';
import { wiresAt } from '../wires-of.ts';
import type { GraphProblem } from './graph-problem.ts';

/** Code of the problem of a module that waits for an input. */
export const INPUT_REQUIRED = 'input_required';

/** What is known of a session while it runs. */
export interface RunState {
  /** True while the modules of the session run, or are paused. */
  readonly isRunning?: boolean;
  /** Whether a module ran several times and never output anything. */
  readonly isSilent?: (node: ModuleNode) => boolean;
}

/** Problems of single modules that keep them from useful work: a missing input, an empty range. */
export function* moduleFaults(graph: Graph, state: RunState): Iterable<GraphProblem> {
  for (const node of graph.nodes.values()) {
    if (node.kind !== 'module' || node.standing !== 'active') continue;
    if (state.isRunning === true) yield* missingInput(graph, node, state);
    yield* emptyRange(graph, node);
  }
}

/** Returns the main input of a module that runs only when an input arrives, while nothing is wired to it. */
export function requiredInput(graph: Graph, node: ModuleNode): Port | undefined {
  const isTriggered = node.module.processingMode?.triggerOnInput !== undefined;
  return isTriggered && !hasSource(graph, node) ? openInput(graph, node) : undefined;
}

function* missingInput(
  graph: Graph,
  node: ModuleNode,
  { isSilent }: RunState,
): Iterable<GraphProblem> {
  const input = openInput(graph, node);
  if (input === undefined) return;
  const isStill = requiredInput(graph, node) !== undefined;
  // Other inputs, or a mode of its own, start runs, in which a module may do without the input.
  if (!isStill && (hasAlternative(graph, node, input) || isSilent?.(node) !== true)) return;
  const { name } = input;
  yield {
    ...warning(node, input),
    code: INPUT_REQUIRED,
    message: isStill
      ? `The input "${name}" is not connected. The module runs when it arrives.`
      : `The input "${name}" is not connected, and the module outputs nothing without it.`,
    consequence: `Waits for ${name}`,
  };
}

const inputsOf = ({ ports }: ModuleNode): readonly Port[] =>
  ports.filter(({ direction }) => direction === 'in');

const hasSource = (graph: Graph, node: ModuleNode): boolean =>
  inputsOf(node).some(({ id: port }) => wiresAt(graph, { node: node.id, port }).length > 0);

/** Whether another input of the same kind has a value, such as the second number of a sum. */
const hasAlternative = (graph: Graph, node: ModuleNode, main: Port): boolean =>
  inputsOf(node).some(
    ({ id: port, name, format, isList, defaultJson }) =>
      defaultJson === undefined &&
      isList === main.isList &&
      formatsFit(format, main.format) &&
      (node.constants.has(name) || wiresAt(graph, { node: node.id, port }).length > 0),
  );

/** Limits of an input range, which divide by their distance. */
const [MIN, MAX] = ['inMin', 'inMax'] as const;

function* emptyRange(graph: Graph, node: ModuleNode): Iterable<GraphProblem> {
  const [min, max] = [fixedNumber(graph, node, MIN), fixedNumber(graph, node, MAX)];
  const port = node.ports.find(({ id }) => id === inputPort(MIN));
  if (port === undefined || min === undefined || min !== max) return;
  yield {
    ...warning(node, port),
    code: 'empty_range',
    message: `${MIN} and ${MAX} are both ${min}: the range is empty. Set two different values.`,
    consequence: `Empty range: ${MIN} = ${MAX}`,
  };
}

/** Number at an input without a wire: the one set there, or the default. */
function fixedNumber(graph: Graph, node: ModuleNode, name: string): number | undefined {
  const port = node.ports.find(({ id }) => id === inputPort(name));
  if (port === undefined || wiresAt(graph, { node: node.id, port: port.id }).length > 0) {
    return undefined;
  }
  try {
    const value: unknown = JSON.parse(node.constants.get(name) ?? port.defaultJson ?? '');
    const [number] = Object.values(value as object) as unknown[];
    return typeof number === 'number' ? number : undefined;
  } catch {
    return undefined;
  }
}

const warning = ({ id }: ModuleNode, { id: port }: Port) => ({
  isError: false,
  node: id,
  port,
  wires: [],
});
