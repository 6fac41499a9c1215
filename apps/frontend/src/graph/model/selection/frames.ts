import type { GraphCommand } from '../commands/graph-command.ts';
import type { FrameNode, Graph, Point, Size } from '../graph.ts';
import { frameNode } from '../make-node.ts';
import { bounds, type Box } from './arrange.ts';
import { framesAround, wouldLoop } from '../nesting.ts';

const PADDING = 24;
/** Height of the title. */
const TITLE = 36;

/** Area of a frame around boxes. */
export function areaAround(boxes: readonly Box[]): Point & Size {
  const { x, y, width, height } = bounds(boxes);
  return {
    x: x - PADDING,
    y: y - TITLE,
    width: width + 2 * PADDING,
    height: height + TITLE + PADDING,
  };
}

/**
 * Adds a frame around nodes, which may be frames. It becomes part of the frame that contains all of them.
 * @param id such as `frame:` and a UUID
 */
export function frameAround({ nodes }: Graph, boxes: readonly Box[], id: string): GraphCommand {
  const { x, y, width, height } = areaAround(boxes);
  const chosen = new Set(boxes.map((box) => box.id));
  const outermost = [...chosen].filter((one) => {
    return !framesAround(nodes, one).some((frame) => chosen.has(frame));
  });
  const [around, ...others] = new Set(outermost.map((one) => nodes.get(one)?.frame));
  const parent = others.length === 0 ? around : undefined;
  const look = { position: { x, y }, size: { width, height }, frame: parent };
  return { kind: 'group', frame: frameNode(id, '', look), nodes: outermost };
}

/** Returns the smallest area that contains the centre of a box. */
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

/** Returns the frame that a box belongs to: frames only go into larger ones, and never into themselves. */
export function frameUnder(
  nodes: Graph['nodes'],
  box: Box,
  frames: readonly Box[],
): string | undefined {
  const isFrame = nodes.get(box.id)?.kind === 'frame';
  const fitting = frames.filter((frame) => {
    if (!isFrame) return frame.id !== box.id;
    return isLarger(frame, box) && !wouldLoop(nodes, box.id, frame.id);
  });
  return areaUnder(box, fitting)?.id;
}

const isLarger = (a: Size, b: Size): boolean => a.width * a.height > b.width * b.height;

/**
 * Assigns nodes to the frames they are in now, and removes them from those they left. Frames can be nested; nodes that
 * moved with their frame stay in it.
 * @param boxes final boxes of the nodes
 * @param frames final boxes of all frames
 */
export function frameChanges(
  { nodes }: Graph,
  boxes: readonly Box[],
  frames: readonly Box[],
): GraphCommand[] {
  const joining = new Map<string | undefined, string[]>();
  for (const box of boxes) {
    const node = nodes.get(box.id);
    if (node === undefined) continue;
    const frame = frameUnder(nodes, box, frames);
    if (frame === node.frame) continue;
    joining.set(frame, [...(joining.get(frame) ?? []), box.id]);
  }
  return [...joining].map(([frame, ids]) => ({ kind: 'setFrame', nodes: ids, frame }));
}

/** Resizes a frame: adds the nodes now inside, and moves those outside to the frame around it. */
export function resizeFrame(
  graph: Graph,
  frame: FrameNode,
  area: Point & Size,
  boxes: readonly Box[],
): GraphCommand {
  const around = framesAround(graph.nodes, frame.id);
  const own = { id: frame.id, ...area };
  const outer = new Set(boxes.filter(({ id }) => around.includes(id)));
  const touched = boxes.filter((box) => {
    const node = graph.nodes.get(box.id);
    if (node === undefined || node.id === frame.id || outer.has(box)) return false;
    if (node.frame === frame.id) return true;
    // Members of other frames stay there.
    const isFree = node.frame === undefined || around.includes(node.frame);
    return isFree && frameUnder(graph.nodes, box, [own]) !== undefined;
  });
  return {
    kind: 'all',
    label: 'Resize the frame',
    commands: [
      { kind: 'resize', node: frame.id, size: sizeOf(area), position: at(area) },
      ...frameChanges(graph, touched, [own, ...outer]),
    ],
  };
}

const at = ({ x, y }: Point): Point => ({ x, y });
const sizeOf = ({ width, height }: Size): Size => ({ width, height });
