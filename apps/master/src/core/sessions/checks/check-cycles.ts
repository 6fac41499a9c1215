import { globToRegExpSource, type SessionProblem, type TopicMux } from '@ubii/proto';
import { plural } from '@ubii/words';
import { quote } from '../../texts/quote.ts';
import type { DraftModule } from '../complete-modules.ts';
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
  link(nodes, context);
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
  const who = plural(
    names.length,
    `The module ${names[0]} is connected to itself`,
    `The modules ${names.join(', ')} are connected in a loop`,
  );
  return isEndless
    ? errorProblem({
        ...about(draft),
        code: 'endless_cycle',
        message: `${who} and run on each input without a delay, so they never stop. Give one of them a minimum delay or a frequency.`,
        path: draft.mappingPath,
      })
    : warningProblem({
        ...about(draft),
        code: 'cycle',
        message: `${who}. Make sure that the values do not grow without limit.`,
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

/** Links each module with those that surely take one of its outputs. */
function link(nodes: readonly Node[], context: CheckContext): void {
  const byTopic = new Map<string, Node[]>();
  const muxed: { readonly node: Node; readonly source: string }[] = [];
  for (const node of nodes) {
    for (const { topic, topicMux } of node.draft.mapping.inputMappings) {
      if (topicMux !== undefined) {
        const source = sourceOf(topicMux);
        if (source !== undefined) muxed.push({ node, source });
      } else if (topic) {
        byTopic.set(topic, [...(byTopic.get(topic) ?? []), node]);
      }
    }
  }
  const matchers = new Map<string, ((topic: string) => boolean) | undefined>();
  for (const { source } of muxed) {
    if (!matchers.has(source)) matchers.set(source, context.matcher(source));
  }
  for (const node of nodes) {
    for (const { topic } of node.draft.mapping.outputMappings) {
      if (!topic) continue;
      for (const next of byTopic.get(topic) ?? []) node.next.add(next);
      const matching = [...matchers].filter(([, matches]) => matches?.(topic) === true);
      const sources = new Set(matching.map(([source]) => source));
      for (const { node: next, source } of muxed) if (sources.has(source)) node.next.add(next);
    }
  }
}

/** Topics of a muxer as a regular expression; undefined for profiles, which select components instead of modules. */
function sourceOf({ component, topicGlob, topicSelector }: TopicMux): string | undefined {
  if (component !== undefined) return undefined;
  const source = topicGlob === '' ? topicSelector : globToRegExpSource(topicGlob);
  return source === '' ? undefined : source;
}

/** The strongly connected parts of a graph that are cycles (Tarjan 1972). */
function cyclesOf(nodes: readonly Node[]): Node[][] {
  const within = new Set(nodes);
  const indices = new Map<Node, number>();
  const lows = new Map<Node, number>();
  const stack: Node[] = [];
  const stacked = new Set<Node>();
  const cycles: Node[][] = [];
  const visit = (node: Node): void => {
    const index = indices.size;
    indices.set(node, index);
    lows.set(node, index);
    stack.push(node);
    stacked.add(node);
    for (const next of node.next) {
      if (!within.has(next)) continue;
      if (!indices.has(next)) {
        visit(next);
        lows.set(node, Math.min(lows.get(node)!, lows.get(next)!));
      } else if (stacked.has(next)) {
        lows.set(node, Math.min(lows.get(node)!, indices.get(next)!));
      }
    }
    if (lows.get(node) !== index) return;
    const part = stack.splice(stack.indexOf(node));
    for (const one of part) stacked.delete(one);
    if (part.length > 1 || node.next.has(node)) cycles.push(part);
  };
  for (const node of nodes) if (!indices.has(node)) visit(node);
  return cycles;
}
