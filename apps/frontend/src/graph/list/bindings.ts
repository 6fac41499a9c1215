import {
  isExtensionTopic,
  isMasterTopic,
  parseDataFormat,
  type ProcessingModule,
} from '@ubii/proto';
import { randomUuid } from '../../connection/random-uuid.ts';
import type { AddableSources } from '../canvas/addable.ts';
import { fitBetween } from '../canvas/port-fit.ts';
import { nodeTitle } from '../nodes/node-label.ts';
import { applyCommand } from '../model/commands/apply-command.ts';
import { proposedTopic } from '../model/commands/free-topic.ts';
import { portName } from '../model/commands/command-label.ts';
import type { GraphCommand } from '../model/commands/graph-command.ts';
import { adaptCommand } from '../model/fit/adapt.ts';
import type { Adapter } from '../model/fit/adapter.ts';
import type { Graph, PortRef } from '../model/graph.ts';
import { topicNode } from '../model/make-node.ts';
import { portFormat, portOf } from '../model/port-format.ts';
import { topicsOf } from '../live/topics-in-graph.ts';

/** Possible source of an input, or target of an output. */
export interface Binding {
  readonly key: string;
  readonly text: string;
  /** Chosen topic; undefined for a port of a node, or a topic that does not exist yet. */
  readonly topic?: string | undefined;
  /** Short name of the data format. */
  readonly hint: string;
  readonly group: 'session' | 'topics' | 'unknown' | 'misfits';
  /** Command that chooses it; undefined when it does not fit. */
  readonly command: GraphCommand | undefined;
  /** Reason why it does not fit, one sentence. */
  readonly reason: string | undefined;
  /** Adapters that would make it fit, best first. */
  readonly offers: readonly Adapter[];
  /** Returns the command that connects it with an adapter. */
  adapt(adapter: Adapter): GraphCommand;
}

const MAX_SHOWN = 80;

/** Returns the sources or targets that match the typed words: fitting ones first, then others with reasons. */
export function bindings(
  graph: Graph,
  ref: PortRef,
  sources: AddableSources,
  typed: string,
  uuid: () => string = randomUuid,
): Binding[] {
  const { modules, topics, nameTopic = (topic) => topic } = sources;
  const own = portOf(graph, ref);
  if (own === undefined) return [];
  const words = typed.toLowerCase().split(/\s+/).filter(Boolean);
  const said = ({ text, hint }: Pick<Binding, 'text' | 'hint'>): boolean =>
    words.every((word) => `${text} ${nameTopic(text)} ${hint}`.toLowerCase().includes(word));
  const used = topicsOf(graph);
  const known = topics.filter(
    ({ topic }) => !isMasterTopic(topic) && !isExtensionTopic(topic) && !used.has(topic),
  );
  const all = [
    ...portsOver(graph, ref).flatMap((far) => between(graph, ref, far, modules, uuid) ?? []),
    ...known.flatMap(({ topic, format }) => {
      const look = { format: parseDataFormat(format) };
      return toTopic(graph, ref, topic, look, modules, uuid) ?? [];
    }),
  ].filter(said);
  const of = (group: Binding['group']): Binding[] => all.filter((one) => one.group === group);
  const made = newTopic(graph, ref, typed.trim(), sources, uuid);
  const fitting = [...of('session'), ...of('topics')];
  // Existing topics come before new ones; without typed words, an output's new topic comes first.
  const best = typed.trim() === '' ? [...made, ...fitting] : [...fitting, ...made];
  return [...best, ...of('unknown'), ...of('misfits')].slice(0, MAX_SHOWN);
}

/** Ports of other nodes, in the opposite direction. */
function portsOver(graph: Graph, ref: PortRef): PortRef[] {
  const direction = portOf(graph, ref)?.direction;
  return [...graph.nodes.values()].flatMap(({ id: node, ports }) =>
    node === ref.node
      ? []
      : ports
          .filter((port) => port.direction !== direction)
          .map(({ id: port }) => ({ node, port })),
  );
}

function between(
  graph: Graph,
  ref: PortRef,
  far: PortRef,
  modules: readonly ProcessingModule[],
  uuid: () => string,
): Binding | undefined {
  const fit = fitBetween(graph, ref, far, modules);
  const node = graph.nodes.get(far.node);
  const port = portOf(graph, far);
  if (fit === undefined || node === undefined || port === undefined) return undefined;
  const { from, to, reason, offers } = fit;
  // Leave out what can never be wired, not even with an adapter.
  if (reason !== undefined && offers.length === 0) return undefined;
  const format = portFormat(graph, far) ?? port.formatText;
  return {
    key: `${far.node} ${far.port}`,
    text:
      node.kind === 'topic' ? node.topic : [nodeTitle(node), port.name].filter(Boolean).join(' · '),
    topic: node.kind === 'topic' ? node.topic : undefined,
    hint: `${format}${port.isList ? ' list' : ''}`,
    group: reason === undefined ? 'session' : 'misfits',
    command: reason === undefined ? { kind: 'connect', from, to } : undefined,
    reason,
    offers,
    adapt: (adapter) => adaptCommand(graph, from, to, adapter, { uuid }),
  };
}

/** Binding to a topic that has no node yet. */
function toTopic(
  graph: Graph,
  ref: PortRef,
  topic: string,
  look: NonNullable<Parameters<typeof topicNode>[1]>,
  modules: readonly ProcessingModule[],
  uuid: () => string,
): Binding | undefined {
  const isInput = portOf(graph, ref)?.direction === 'in';
  const node = topicNode(topic, look);
  const add: GraphCommand = { kind: 'add', nodes: [node] };
  const wider = applyCommand(graph, add).graph;
  const far = { node: node.id, port: isInput ? 'out' : 'in' };
  const binding = between(wider, ref, far, modules, uuid);
  if (binding === undefined) return undefined;
  const label = isInput
    ? `Connect ${topic} to ${portName(graph, ref)}`
    : `Connect ${portName(graph, ref)} to ${topic}`;
  const after = (command: GraphCommand): GraphCommand => ({
    kind: 'all',
    label,
    commands: [add, command],
  });
  return {
    ...binding,
    group:
      binding.reason !== undefined ? 'misfits' : look.format === undefined ? 'unknown' : 'topics',
    command: binding.command && after(binding.command),
    adapt: (adapter) => after(binding.adapt(adapter)),
  };
}

/** A topic without a publisher: with the typed name, or for an output with a generated name. */
function newTopic(
  graph: Graph,
  ref: PortRef,
  typed: string,
  { topics, used }: AddableSources,
  uuid: () => string,
): Binding[] {
  const isOutput = portOf(graph, ref)?.direction === 'out';
  if (graph.nodes.get(ref.node)?.kind !== 'module' || /\s/.test(typed)) return [];
  if (typed === '' && !isOutput) return [];
  const topic =
    typed === '' ? proposedTopic(graph, ref, used) : typed.startsWith('/') ? typed : `/${typed}`;
  if (topicsOf(graph).has(topic) || topics.some((one) => one.topic === topic)) return [];
  const binding = toTopic(graph, ref, topic, {}, [], uuid);
  if (binding?.command === undefined) return [];
  const text = `New topic ${topic}`;
  return [{ ...binding, key: `new ${topic}`, text, topic: undefined, group: 'topics' }];
}
