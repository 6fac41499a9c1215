import type { Graph, GraphNode } from './graph.ts';

type Nodes = Graph['nodes'];

/**
 * Returns the frames around a node, innermost first. Stops at cycles, which editor data of other programs may contain.
 */
export function framesAround(nodes: Nodes, id: string): string[] {
  const around: string[] = [];
  const seen = new Set([id]);
  let frame = nodes.get(id)?.frame;
  while (frame !== undefined && nodes.get(frame)?.kind === 'frame' && !seen.has(frame)) {
    seen.add(frame);
    around.push(frame);
    frame = nodes.get(frame)?.frame;
  }
  return around;
}

/** True when adding the node to the frame would make a frame contain itself. */
export const wouldLoop = (nodes: Nodes, id: string, frame: string): boolean =>
  id === frame || framesAround(nodes, frame).includes(id);

/** Returns these nodes and, recursively, the contents of the frames among them. */
export function withContents({ nodes }: Graph, ids: Iterable<string>): Set<string> {
  const chosen = new Set([...ids].filter((id) => nodes.has(id)));
  if (![...chosen].some((id) => nodes.get(id)?.kind === 'frame')) return chosen;
  const frames = new Set(chosen);
  for (const id of nodes.keys()) {
    if (framesAround(nodes, id).some((frame) => frames.has(frame))) chosen.add(id);
  }
  return chosen;
}

/** Returns the innermost frame around a node that is not removed. */
export const frameLeft = (
  nodes: Nodes,
  id: string,
  gone: ReadonlySet<string>,
): string | undefined => framesAround(nodes, id).find((frame) => !gone.has(frame));

/** Breaks cycles of frames, which can result from merging the changes of two users. */
export function breakLoops(nodes: Map<string, GraphNode>): void {
  for (const node of [...nodes.values()]) {
    const { id, frame } = node;
    if (node.kind !== 'frame' || frame === undefined) continue;
    if (wouldLoop(nodes, id, frame)) nodes.set(id, { ...node, frame: undefined });
  }
}
