import { globToRegExpSource, type SessionProblem } from '@ubii/proto';
import { quote } from '../../topics/topic-names.ts';
import type { DraftModule } from '../draft.ts';
import { errorProblem, warningProblem } from '../problems.ts';
import { about, type Check, type CheckContext } from './check-context.ts';

interface Node {
  readonly draft: DraftModule;
  /** Modules that take what this one gives. */
  readonly next: Set<Node>;
}

/** Modules that feed each other: without end, or in any other way [SE-4] [SE-5]. */
export const checkCycles: Check = function* (modules, context) {
  const nodes = modules.map((draft): Node => ({ draft, next: new Set() }));
  for (const node of nodes) {
    for (const other of nodes) if (feeds(node.draft, other.draft, context)) node.next.add(other);
  }
  const endless = new Set<Node>();
  for (const cycle of cyclesOf(nodes.filter(({ draft }) => isImmediate(draft)))) {
    for (const node of cycle) endless.add(node);
    yield describe(cycle, true);
  }
  for (const cycle of cyclesOf(nodes)) {
    if (!cycle.some((node) => endless.has(node))) yield describe(cycle, false);
  }
};

function describe(cycle: readonly Node[], isEndless: boolean): SessionProblem {
  const names = cycle.map(({ draft }) => quote(draft.spec.name));
  const { draft } = cycle[0]!;
  const who =
    names.length === 1
      ? `The module ${names[0]} feeds itself`
      : `The modules ${names.join(', ')} feed each other`;
  return isEndless
    ? errorProblem({
        ...about(draft),
        code: 'endless_cycle',
        message: `${who} and run without any delay on each input, which never ends; give one of them a minimal delay or a frequency.`,
        path: draft.mappingPath,
      })
    : warningProblem({
        ...about(draft),
        code: 'cycle',
        message: `${who}; see to it that the values do not grow without end.`,
        path: draft.mappingPath,
      });
}

/** Whether one input alone makes it run at once. */
function isImmediate({ spec, mapping }: DraftModule): boolean {
  const trigger = spec.processingMode?.triggerOnInput;
  if (trigger === undefined || trigger.minDelayMs > 0) return false;
  // One that waits for all its inputs waits for those from outside.
  return !trigger.allInputsNeedUpdate || mapping.inputMappings.length === 1;
}

/** Whether an output of the one is surely an input of the other. */
function feeds(one: DraftModule, other: DraftModule, context: CheckContext): boolean {
  for (const { topic } of one.mapping.outputMappings) {
    if (topic === undefined || topic === '') continue;
    for (const input of other.mapping.inputMappings) {
      if (input.topic === topic) return true;
      if (input.topicMux === undefined || input.topicMux.component !== undefined) continue;
      const { topicGlob, topicSelector } = input.topicMux;
      const source = topicGlob === '' ? topicSelector : globToRegExpSource(topicGlob);
      if (
        source !== '' &&
        context.patternFault(source) === undefined &&
        context.matches(source, topic)
      ) {
        return true;
      }
    }
  }
  return false;
}

/** The strongly connected parts of a graph that are cycles (Tarjan 1972). */
function cyclesOf(nodes: readonly Node[]): Node[][] {
  const within = new Set(nodes);
  const indices = new Map<Node, number>();
  const lows = new Map<Node, number>();
  const stack: Node[] = [];
  const cycles: Node[][] = [];
  const visit = (node: Node): void => {
    const index = indices.size;
    indices.set(node, index);
    lows.set(node, index);
    stack.push(node);
    for (const next of node.next) {
      if (!within.has(next)) continue;
      if (!indices.has(next)) {
        visit(next);
        lows.set(node, Math.min(lows.get(node)!, lows.get(next)!));
      } else if (stack.includes(next)) {
        lows.set(node, Math.min(lows.get(node)!, indices.get(next)!));
      }
    }
    if (lows.get(node) !== index) return;
    const part = stack.splice(stack.indexOf(node));
    if (part.length > 1 || node.next.has(node)) cycles.push(part);
  };
  for (const node of nodes) if (!indices.has(node)) visit(node);
  return cycles;
}
