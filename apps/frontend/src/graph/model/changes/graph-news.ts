import { isSameValue } from '@ubii/proto';
import { plural } from '@ubii/words';

import { nodeName, portName } from '../commands/command-label.ts';
import type { Graph, GraphNode } from '../graph.ts';
import { wishedNode } from './wished-node.ts';

/** A change of a graph, in words, and its node. */
export interface GraphNews {
  /** Text to follow the name of a user: `added statistics`. */
  readonly words: string;
  /** Id of the changed node; undefined when it was removed or the whole graph is concerned. */
  readonly node: string | undefined;
}

/** Describes the changes of a user. Positions count only when nothing else has changed. */
export function graphNews(before: Graph, after: Graph): GraphNews[] {
  const news = [...nodeNews(before, after), ...wireNews(before, after)];
  if (before.details.name !== after.details.name) {
    news.push({ words: `renamed the session to ${after.details.name}`, node: undefined });
  } else if (!isSameValue(before.details, after.details)) {
    news.push({ words: 'changed the details of the session', node: undefined });
  }
  if (news.length > 0) return news;
  const moved = [...after.nodes.values()].filter((node) => {
    const old = before.nodes.get(node.id);
    return old === undefined || !isSameValue(look(old), look(node));
  });
  if (moved.length > 0) {
    const words = plural(
      moved.length,
      `moved ${nodeName(moved[0])}`,
      `moved ${moved.length} nodes`,
    );
    return [{ words, node: moved[0]?.id }];
  }
  const led = [...after.wires.values()].find(
    ({ id, points, via }) =>
      !isSameValue(before.wires.get(id)?.points, points) || before.wires.get(id)?.via !== via,
  );
  return led === undefined ? [] : [{ words: 'rerouted wires', node: led.to.node }];
}

const look = ({ position, size, isCollapsed, frame }: GraphNode): unknown => ({
  position,
  size,
  isCollapsed,
  frame,
});

function* nodeNews(before: Graph, after: Graph): Iterable<GraphNews> {
  for (const [id, node] of after.nodes) {
    const old = before.nodes.get(id);
    if (old === undefined) yield { words: `added ${nodeName(node)}`, node: id };
    else if (!isSameValue(essence(old), essence(node))) {
      yield { words: `changed ${nodeName(node)}`, node: id };
    }
  }
  for (const [id, node] of before.nodes) {
    if (!after.nodes.has(id)) yield { words: `deleted ${nodeName(node)}`, node: undefined };
  }
}

/** Node without position and without properties that only the master sets. */
function essence(node: GraphNode): unknown {
  const { position: _p, size: _s, isCollapsed: _c, frame: _f, ports: _o, ...rest } = node;
  if (rest.kind !== 'module') return rest;
  const { status: _status, sessionId: _session, extension: _extension, ...module } = rest.module;
  // A node chosen by the master is no change of the user.
  return { ...rest, module: { ...module, nodeId: wishedNode(rest.module) } };
}

function* wireNews(before: Graph, after: Graph): Iterable<GraphNews> {
  for (const [id, { from, to }] of after.wires) {
    if (before.wires.has(id)) continue;
    yield { words: `connected ${portName(after, from)} to ${portName(after, to)}`, node: to.node };
  }
  for (const [id, { from, to }] of before.wires) {
    if (after.wires.has(id)) continue;
    // Wires of removed nodes are removed with them.
    if (!after.nodes.has(from.node) || !after.nodes.has(to.node)) continue;
    const words = `took ${portName(before, to)} off ${portName(before, from)}`;
    yield { words, node: to.node };
  }
}
