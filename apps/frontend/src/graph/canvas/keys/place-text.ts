import { counted } from '@ubii/words';

import { topicOfWire } from '../../live/topics-in-graph.ts';
import { portName } from '../../model/commands/command-label.ts';
import type { Graph } from '../../model/graph.ts';
import { portFormat, portOf } from '../../model/port-format.ts';
import { wiresAt, wiresOf } from '../../model/wires-of.ts';
import { nodeKind, nodeTitle } from '../../nodes/node-label.ts';
import type { KeyPlace } from './key-walk.ts';

/** Full name of a node or socket, and its description. */
export interface PlaceText {
  readonly name: string;
  readonly rest: string;
}

/** Returns the text for keyboard users about the focused node or socket. */
export function placeText(graph: Graph, { node: id, port }: KeyPlace): PlaceText | undefined {
  const node = graph.nodes.get(id);
  if (node === undefined) return undefined;
  if (port === undefined) {
    const { in: incoming, out } = wiresOf(graph, id);
    const count = incoming.length + out.length;
    const name = node.kind === 'topic' ? node.topic : nodeTitle(node);
    const wires = count === 0 ? 'no wires' : counted(count, 'wire');
    return { name, rest: `${nodeKind(node).toLowerCase()}, ${wires}` };
  }
  const ref = { node: id, port };
  const own = portOf(graph, ref);
  if (own === undefined) return undefined;
  const isInput = own.direction === 'in';
  const format = portFormat(graph, ref) ?? (own.formatText || 'any format');
  const ends = wiresAt(graph, ref).map(({ from, to }) => portName(graph, isInput ? from : to));
  const state = ends.length === 0 ? 'not connected' : `connected to ${ends.join(', ')}`;
  const side = isInput ? 'input' : 'output';
  return { name: portName(graph, ref), rest: `${side}, ${format}, ${state}` };
}

/** Returns the current value at a node or socket, one sentence; empty if there is none. */
export function valueText(
  graph: Graph,
  { node: id, port }: KeyPlace,
  valueOf: (topic: string) => string | undefined,
): string {
  const node = graph.nodes.get(id);
  if (node === undefined) return '';
  const ofTopic = (topic: string | undefined): string => {
    const value = topic === undefined ? undefined : valueOf(topic);
    return value === undefined ? '' : `Value ${value}.`;
  };
  if (node.kind === 'topic') return ofTopic(node.topic) || 'Nothing published.';
  if (port === undefined) return '';
  const [wire] = wiresAt(graph, { node: id, port });
  if (wire !== undefined) return ofTopic(topicOfWire(graph, wire));
  if (node.kind !== 'module') return '';
  const own = portOf(graph, { node: id, port });
  const json = own && node.constants.get(own.name);
  return json === undefined ? '' : `Value ${json}.`;
}
