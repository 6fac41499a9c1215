import type { GraphCommand } from '../commands/graph-command.ts';
import type { FrameNode, Graph, Point, Size } from '../graph.ts';
import { frameNode } from '../make-node.ts';
import { bounds, type Box } from './arrange.ts';

const PADDING = 24;
/** Room for the title. */
const TITLE = 36;

/** Where a frame around boxes lies. */
export function areaAround(boxes: readonly Box[]): Point & Size {
  const { x, y, width, height } = bounds(boxes);
  return {
    x: x - PADDING,
    y: y - TITLE,
    width: width + 2 * PADDING,
    height: height + TITLE + PADDING,
  };
}

/** Puts a new frame around nodes. @param id such as `frame:` and a UUID */
export function frameAround(boxes: readonly Box[], id: string): GraphCommand {
  const { x, y, width, height } = areaAround(boxes);
  const frame = frameNode(id, '', { position: { x, y }, size: { width, height } });
  return { kind: 'group', frame, nodes: boxes.map((box) => box.id) };
}

/** The smallest of these areas that has the middle of a box in it. */
export function areaUnder(box: Point & Size, areas: readonly Box[]): Box | undefined {
  const x = box.x + box.width / 2;
  const y = box.y + box.height / 2;
  let best: Box | undefined;
  for (const area of areas) {
    const isIn =
      x >= area.x && x <= area.x + area.width && y >= area.y && y <= area.y + area.height;
    if (!isIn) continue;
    if (best === undefined || area.width * area.height < best.width * best.height) best = area;
  }
  return best;
}

/**
 * Puts nodes into the frames they lie in now, and takes them out of those they have left. Frames
 * are in no frames, and what moved with its frame stays in it.
 * @param boxes the nodes, where they come to lie
 * @param frames all frames, where they come to lie
 */
export function frameChanges(
  graph: Graph,
  boxes: readonly Box[],
  frames: readonly Box[],
): GraphCommand[] {
  const joining = new Map<string | undefined, string[]>();
  for (const box of boxes) {
    const node = graph.nodes.get(box.id);
    if (node === undefined || node.kind === 'frame') continue;
    const frame = areaUnder(box, frames)?.id;
    if (frame === node.frame) continue;
    joining.set(frame, [...(joining.get(frame) ?? []), box.id]);
  }
  return [...joining].map(([frame, nodes]) => ({ kind: 'setFrame', nodes, frame }));
}

/** A frame in another size: what lies in it then is in it. */
export function resizeFrame(
  graph: Graph,
  frame: FrameNode,
  area: Point & Size,
  boxes: readonly Box[],
): GraphCommand {
  const inside = boxes.filter(({ id }) => {
    const node = graph.nodes.get(id);
    // Members of other frames stay where they are.
    return node?.kind !== 'frame' && (node?.frame === undefined || node.frame === frame.id);
  });
  return {
    kind: 'all',
    label: 'Resize the frame',
    commands: [
      { kind: 'resize', node: frame.id, size: sizeOf(area), position: at(area) },
      ...frameChanges(graph, inside, [{ id: frame.id, ...area }]),
    ],
  };
}

const at = ({ x, y }: Point): Point => ({ x, y });
const sizeOf = ({ width, height }: Size): Size => ({ width, height });
