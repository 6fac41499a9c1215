import { isSameValue } from '@ubii/proto';
import { nodeName, portName } from '../commands/command-label.ts';
import { replaceValue } from '../commands/connect.ts';
import type { GraphCommand } from '../commands/graph-command.ts';
import { GraphEdit } from '../commands/graph-edit.ts';
import { revealTopic } from '../commands/reveal-topic.ts';
import type { Graph, GraphNode, Wire } from '../graph.ts';
import { topicNodeId } from '../make-node.ts';
import { breakLoops } from '../nesting.ts';
import { wiresAt } from '../wires-of.ts';
import type { Conflict } from './conflict.ts';
import { mergeNode } from './merge-node.ts';
import { mergeMembers, threeWay } from './three-way.ts';

/** Result of merging the changes of two users. */
export interface Merged {
  readonly graph: Graph;
  /** Elements that both changed; the graph has the own change. */
  readonly conflicts: readonly Conflict[];
}

/**
 * Merges the changes of another user into own changes, element by element. An element that one user changed and the
 * other did not has that change; one that one user removed and the other changed or used stays.
 *
 * @param base common ancestor of both versions
 */
export function mergeGraphs(base: Graph, mine: Graph, theirs: Graph): Merged {
  const conflicts: Conflict[] = [];
  const nodes = mergeNodes(base, mine, theirs, conflicts);
  const wires = mergeWires(base, mine, theirs, conflicts);
  keepEnds(nodes, wires, mine, theirs, conflicts);
  const details = mergeMembers(base.details, mine.details, theirs.details, (member, value, own) =>
    conflicts.push({
      node: undefined,
      wire: undefined,
      what: `The ${member} of the session`,
      theirs: value,
      mine: own,
      takeTheirs: { kind: 'setDetails', changes: { [member]: value } },
      takeMine: undefined,
    }),
  );
  const foreign = threeWay(base.foreign, mine.foreign, theirs.foreign).value;
  const graph = settled({ nodes, wires, details, foreign }, { mine, theirs }, conflicts);
  return { graph, conflicts };
}

function mergeNodes(
  base: Graph,
  mine: Graph,
  theirs: Graph,
  conflicts: Conflict[],
): Map<string, GraphNode> {
  const nodes = new Map<string, GraphNode>();
  for (const id of new Set([...theirs.nodes.keys(), ...mine.nodes.keys()])) {
    const [b, m, t] = [base.nodes.get(id), mine.nodes.get(id), theirs.nodes.get(id)];
    if (m !== undefined && t !== undefined) {
      nodes.set(id, mergedNode(b ?? m, m, t, conflicts));
    } else if (m !== undefined) {
      if (b === undefined || !sameNode(b, m)) nodes.set(id, m);
      if (b !== undefined && !sameNode(b, m)) conflicts.push(removedByThem(m));
    } else if (t !== undefined) {
      if (b === undefined || !sameNode(b, t)) nodes.set(id, t);
      if (b !== undefined && !sameNode(b, t)) conflicts.push(removedByMe(t));
    }
  }
  return nodes;
}

/** Returns one of the two nodes itself if it is the result, so that equal nodes stay the same object. */
function mergedNode(
  base: GraphNode,
  mine: GraphNode,
  theirs: GraphNode,
  conflicts: Conflict[],
): GraphNode {
  const whole = threeWay(base, mine, theirs);
  if (whole.kind === 'same' || whole.kind === 'theirs') return theirs;
  return whole.kind === 'mine' ? mine : mergeNode(base, mine, theirs, conflicts);
}

/** Positions are not compared. */
function sameNode(a: GraphNode, b: GraphNode): boolean {
  const { position: _p, size: _s, isCollapsed: _c, frame: _f, ports: _o, ...ours } = a;
  const { position: _q, size: _t, isCollapsed: _d, frame: _g, ports: _r, ...others } = b;
  return isSameValue(ours, others);
}

const removedByThem = (node: GraphNode): Conflict => ({
  node: node.id,
  wire: undefined,
  what: `${nodeName(node)}, which another client deleted`,
  theirs: undefined,
  mine: node,
  takeTheirs: { kind: 'remove', nodes: [node.id] },
  takeMine: undefined,
});

/** The other user changed a node that this user removed: keep it and ask. */
const removedByMe = (node: GraphNode): Conflict => ({
  node: node.id,
  wire: undefined,
  what: `${nodeName(node)}, which you deleted and another client changed`,
  theirs: node,
  mine: undefined,
  takeTheirs: { kind: 'all', commands: [], label: `Keep ${nodeName(node)}` },
  takeMine: { kind: 'remove', nodes: [node.id] },
});

function mergeWires(
  base: Graph,
  mine: Graph,
  theirs: Graph,
  conflicts: Conflict[],
): Map<string, Wire> {
  const wires = new Map<string, Wire>();
  for (const id of new Set([...theirs.wires.keys(), ...mine.wires.keys()])) {
    const [b, m, t] = [base.wires.get(id), mine.wires.get(id), theirs.wires.get(id)];
    if (m !== undefined && t !== undefined) {
      const origin = b ?? t;
      const via = threeWay(origin.via, m.via, t.via);
      if (via.kind === 'conflict' && t.via !== undefined) {
        conflicts.push({
          node: undefined,
          wire: id,
          what: `The topic from ${portName(mine, m.from)} to ${portName(mine, m.to)}`,
          theirs: t.via,
          mine: m.via,
          takeTheirs: { kind: 'setVia', wire: id, topic: t.via },
          takeMine: undefined,
        });
      }
      const points = threeWay(origin.points, m.points, t.points).value;
      const merged = { ...m, via: via.value, points };
      wires.set(id, isSameValue(merged, t) ? t : merged);
    } else {
      // Keep wires that one user added, drop wires that one user removed.
      const wire = m ?? t;
      if (wire !== undefined && b === undefined) wires.set(id, wire);
    }
  }
  return wires;
}

/** A wire added by one user keeps its end nodes, also if the other user removed them. */
function keepEnds(
  nodes: Map<string, GraphNode>,
  wires: ReadonlyMap<string, Wire>,
  mine: Graph,
  theirs: Graph,
  conflicts: Conflict[],
): void {
  for (const { from, to } of wires.values()) {
    for (const { node: id } of [from, to]) {
      if (nodes.has(id)) continue;
      const [m, t] = [mine.nodes.get(id), theirs.nodes.get(id)];
      const node = m ?? t;
      if (node === undefined) continue;
      nodes.set(id, node);
      conflicts.push(m === undefined ? removedByMe(node) : removedByThem(node));
    }
  }
  for (const node of nodes.values()) {
    if (node.frame !== undefined && !nodes.has(node.frame)) {
      nodes.set(node.id, { ...node, frame: undefined });
    }
  }
  breakLoops(nodes);
}

/** Restores the rules of graphs: one wire per input, one writer per topic without a node. */
function settled(
  graph: Graph,
  both: { readonly mine: Graph; readonly theirs: Graph },
  conflicts: Conflict[],
): Graph {
  const edit = new GraphEdit(graph);
  const dangling = [...graph.wires.values()].filter(
    ({ from, to }) => !graph.nodes.has(from.node) || !graph.nodes.has(to.node),
  );
  edit.removeWires(dangling.map(({ id }) => id));
  for (const wire of edit.graph.wires.values()) settleInput(edit, wire, both, conflicts);
  for (const wire of edit.graph.wires.values()) replaceValue(edit, wire);
  const writers = new Map<string, string>();
  for (const { via, from } of edit.graph.wires.values()) {
    if (via === undefined) continue;
    const writer = `${from.node} ${from.port}`;
    const other = writers.get(via);
    writers.set(via, writer);
    const isShared = other !== undefined && other !== writer;
    if (isShared || edit.graph.nodes.has(topicNodeId(via))) revealTopic(edit, via);
  }
  return edit.graph;
}

/** Both users wired the same input: keep the own wire. */
function settleInput(
  edit: GraphEdit,
  wire: Wire,
  { mine, theirs }: { readonly mine: Graph; readonly theirs: Graph },
  conflicts: Conflict[],
): void {
  if (!edit.graph.wires.has(wire.id) || mine.wires.has(wire.id)) return;
  const { graph } = edit;
  if (graph.nodes.get(wire.to.node)?.kind !== 'module') return;
  const own = wiresAt(graph, wire.to).find(({ id }) => mine.wires.has(id) && !theirs.wires.has(id));
  if (own === undefined) return;
  const { from, to, via } = wire;
  const takeTheirs: GraphCommand = {
    kind: 'connect',
    from,
    to,
    ...(via !== undefined && { via }),
  };
  conflicts.push({
    node: to.node,
    wire: own.id,
    what: `Source of ${portName(graph, to)}`,
    theirs: portName(graph, from),
    mine: portName(graph, own.from),
    takeTheirs,
    takeMine: undefined,
  });
  edit.removeWires([wire.id]);
}
