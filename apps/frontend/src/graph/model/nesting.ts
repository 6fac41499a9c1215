import type { Graph, GraphNode } from './graph.ts';

type Nodes = Graph['nodes'];

/** The frames a node is in, the nearest first. Editor data of others may lead in a circle: it ends there. */
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

/** True when putting the node into the frame would put a frame into itself. */
export const wouldLoop = (nodes: Nodes, id: string, frame: string): boolean =>
  id === frame || framesAround(nodes, frame).includes(id);

/** These nodes, and all that is in the frames among them, frames in frames too. */
export function withContents({ nodes }: Graph, ids: Iterable<string>): Set<string> {
  const chosen = new Set([...ids].filter((id) => nodes.has(id)));
  if (![...chosen].some((id) => nodes.get(id)?.kind === 'frame')) return chosen;
  const frames = new Set(chosen);
  for (const id of nodes.keys()) {
    if (framesAround(nodes, id).some((frame) => frames.has(frame))) chosen.add(id);
  }
  return chosen;
}

/** The nearest frame around a node that is not among those that go. */
export const frameLeft = (
  nodes: Nodes,
  id: string,
  gone: ReadonlySet<string>,
): string | undefined => framesAround(nodes, id).find((frame) => !gone.has(frame));

/** Takes frames that lie in each other out of each other: two people can have made that together. */
export function breakLoops(nodes: Map<string, GraphNode>): void {
  for (const node of [...nodes.values()]) {
    const { id, frame } = node;
    if (node.kind !== 'frame' || frame === undefined) continue;
    if (wouldLoop(nodes, id, frame)) nodes.set(id, { ...node, frame: undefined });
  }
}
