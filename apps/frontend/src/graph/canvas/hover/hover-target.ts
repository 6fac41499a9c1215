import { topicAt, topicOfWire } from '../../live/topics-in-graph.ts';
import type { Graph, PortRef } from '../../model/graph.ts';
import { portFormat, portOf } from '../../model/port-format.ts';
import { wiresAt } from '../../model/wires-of.ts';
import { nodeTitle } from '../../nodes/node-label.ts';

/** Hovered element: a wire with its chip, or a socket. */
export type HoverTarget =
  | { readonly kind: 'wire'; readonly wire: string }
  | { readonly kind: 'port'; readonly ref: PortRef };

/** Texts of the hover card. */
export interface HoverWords {
  readonly title: string;
  /** Topic of the values; undefined when there is no single topic. */
  readonly topic: string | undefined;
  readonly format: string;
  /** Description of the values of an input or output of a module. [PM-6] */
  readonly about?: string | undefined;
  /** Text shown instead of values. */
  readonly note: string | undefined;
}

/** Returns the wire or socket that an element of the canvas belongs to. */
export function hoverTarget(element: Element | null): HoverTarget | undefined {
  const found = element?.closest<HTMLElement>('[data-wire], [data-wire-chip], [data-port]');
  const { wire, wireChip, node, port } = found?.dataset ?? {};
  const id = wire ?? wireChip;
  if (id !== undefined) return { kind: 'wire', wire: id };
  return node === undefined || port === undefined
    ? undefined
    : { kind: 'port', ref: { node, port } };
}

export function hoverWords(graph: Graph, target: HoverTarget): HoverWords | undefined {
  if (target.kind === 'wire') {
    const wire = graph.wires.get(target.wire);
    if (wire === undefined) return undefined;
    const format = portFormat(graph, wire.from) ?? portFormat(graph, wire.to) ?? 'any format';
    const ends = `${endWords(graph, wire.from)} → ${endWords(graph, wire.to)}`;
    const source = graph.nodes.get(wire.from.node);
    const note =
      source?.kind === 'constant' ? `Constant ${source.json}` : 'Values of many topics as a list';
    const topic = topicOfWire(graph, wire);
    return { title: ends, topic, format, note: topic === undefined ? note : undefined };
  }
  const port = portOf(graph, target.ref);
  const node = graph.nodes.get(target.ref.node);
  if (port === undefined || node === undefined) return undefined;
  const format = `${portFormat(graph, target.ref) ?? (port.formatText || 'any format')}${port.isList ? ' list' : ''}`;
  const [wire] = wiresAt(graph, target.ref);
  const topic = topicAt(graph, target.ref);
  const side = port.direction === 'in' ? 'Input' : 'Output';
  const constant = node.kind === 'module' ? node.constants.get(port.name) : undefined;
  const note =
    topic !== undefined ? undefined : wire ? 'Values of many topics as a list' : noteOf(constant);
  const title = `${side} ${port.name || nodeTitle(node)}`;
  return { title, topic, format, about: port.description, note };
}

const noteOf = (constant: string | undefined): string =>
  constant === undefined ? 'Not connected' : `Not connected, constant ${constant}`;

function endWords(graph: Graph, ref: PortRef): string {
  const node = graph.nodes.get(ref.node);
  const port = portOf(graph, ref)?.name;
  return [node ? nodeTitle(node) : '', port].filter(Boolean).join(' · ');
}
