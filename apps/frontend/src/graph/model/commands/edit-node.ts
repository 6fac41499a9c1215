import type { Graph, GraphNode, NodeKind, Point, Wire } from '../graph.ts';
import { constantNode, demuxerNode, moduleNode, muxerNode } from '../make-node.ts';
import { inputPort, ioName } from '../ports.ts';
import { framesAround } from '../nesting.ts';
import { wiresAt, wiresOf } from '../wires-of.ts';
import type { CommandOf } from './graph-command.ts';
import type { GraphEdit } from './graph-edit.ts';

type NodeOf<K extends NodeKind> = Extract<GraphNode, { readonly kind: K }>;

/** Replaces a node, if it exists. */
export function editNode(
  edit: GraphEdit,
  id: string,
  change: (node: GraphNode) => GraphNode,
): void {
  const node = edit.graph.nodes.get(id);
  if (node !== undefined) edit.putNodes([change(node)]);
}

function editOf<K extends NodeKind>(
  edit: GraphEdit,
  id: string,
  kind: K,
  change: (node: NodeOf<K>) => GraphNode,
): void {
  editNode(edit, id, (node) => (node.kind === kind ? change(node as NodeOf<K>) : node));
}

/** Returns nodes at new positions; frames take along the nodes in them that are not moved themselves. */
export function moved(graph: Graph, positions: ReadonlyMap<string, Point>): GraphNode[] {
  const frames = new Map<string, Point>();
  const nodes: GraphNode[] = [];
  for (const [id, position] of positions) {
    const node = graph.nodes.get(id);
    if (node === undefined || isSamePlace(node.position, position)) continue;
    nodes.push({ ...node, position });
    if (node.kind !== 'frame' || node.position === undefined) continue;
    frames.set(id, { x: position.x - node.position.x, y: position.y - node.position.y });
  }
  if (frames.size === 0) return nodes;
  for (const node of graph.nodes.values()) {
    if (node.frame === undefined || node.position === undefined || positions.has(node.id)) continue;
    // The distance is that of the nearest frame with a new position.
    const frame = framesAround(graph.nodes, node.id).find((id) => positions.has(id));
    const by = frame === undefined ? undefined : frames.get(frame);
    if (by === undefined) continue;
    nodes.push({ ...node, position: { x: node.position.x + by.x, y: node.position.y + by.y } });
  }
  return nodes;
}

const isSamePlace = (a: Point | undefined, b: Point): boolean => a?.x === b.x && a.y === b.y;

export const setModule = (edit: GraphEdit, { node, changes }: CommandOf<'setModule'>): void =>
  editOf(edit, node, 'module', (old) => {
    // Keep the id, by which other clients know the module.
    const module = { ...old.module, ...changes, id: old.module.id };
    const wires = wiresOf(edit.graph, node);
    return moduleNode(module, {
      ...old,
      mappedInputs: names(wires.in, ({ to }) => to.port),
      mappedOutputs: names(wires.out, ({ from }) => from.port),
    });
  });

const names = (wires: readonly Wire[], portOf: (wire: Wire) => string): string[] =>
  wires.map((wire) => ioName(portOf(wire)));

/** A value set at an input replaces a constant node wired to it. */
export const setConstant = (
  edit: GraphEdit,
  { node, input, json = '' }: CommandOf<'setConstant'>,
): void => {
  editOf(edit, node, 'module', (old) => {
    if ((old.constants.get(input) ?? '') === json) return old;
    const constants = new Map(old.constants);
    if (json === '') constants.delete(input);
    else constants.set(input, json);
    return { ...old, constants };
  });
  if (json === '') return;
  const wired = wiresAt(edit.graph, { node, port: inputPort(input) });
  const fromConstants = wired.filter(
    ({ from }) => edit.graph.nodes.get(from.node)?.kind === 'constant',
  );
  edit.removeWires(fromConstants.map(({ id }) => id));
};

export const setStanding = (
  edit: GraphEdit,
  { nodes, standing }: CommandOf<'setStanding'>,
): void => {
  for (const id of nodes) editOf(edit, id, 'module', (old) => ({ ...old, standing }));
};

export const setMuxer = (edit: GraphEdit, { node, changes }: CommandOf<'setMuxer'>): void =>
  editOf(edit, node, 'muxer', (old) => muxerNode({ ...old.mux, ...changes, id: old.mux.id }, old));

export const setDemuxer = (edit: GraphEdit, { node, changes }: CommandOf<'setDemuxer'>): void =>
  editOf(edit, node, 'demuxer', (old) =>
    demuxerNode({ ...old.demux, ...changes, id: old.demux.id }, old),
  );

export const setValue = (edit: GraphEdit, { node, json }: CommandOf<'setValue'>): void =>
  editOf(edit, node, 'constant', (old) => constantNode(old.id, json, old));

export const setText = (edit: GraphEdit, { node, text }: CommandOf<'setText'>): void =>
  editNode(edit, node, (old) => {
    switch (old.kind) {
      case 'comment':
        return { ...old, text };
      case 'frame':
        return { ...old, title: text };
      case 'constant':
        return { ...old, name: text };
      default:
        return old;
    }
  });

export const setColor = (edit: GraphEdit, { frame, color }: CommandOf<'setColor'>): void =>
  editOf(edit, frame, 'frame', (old) => ({ ...old, color }));
