import type { Point, Wire } from '../model/graph.ts';
import type { CanvasStage } from './canvas-stage.ts';

/** The widest chip, pixels at a zoom of 1. */
export const MAX_CHIP = 220;
/** Half of a chip, and some air, above and below its middle. */
const HALF_HEIGHT = 14;
/** From the edge of a node: sockets reach out of it. */
const SOCKET = 14;

type Drawn = Pick<CanvasStage, 'positions' | 'sizes'>;

/**
 * How wide the chip of a wire may be without covering sockets of the nodes at its ends, pixels.
 * @param middle of the chip
 */
export function chipRoom(stage: Drawn, { from, to }: Wire, middle: Point | undefined): number {
  if (middle === undefined) return 0;
  let half = MAX_CHIP / 2;
  for (const id of [from.node, to.node]) {
    const position = stage.positions.get(id);
    const size = stage.sizes.get(id);
    if (position === undefined || size === undefined) continue;
    const { x, y } = position;
    const isBeside = middle.y > y - HALF_HEIGHT && middle.y < y + size.height + HALF_HEIGHT;
    if (!isBeside) continue;
    const gap = middle.x < x ? x - middle.x : middle.x - x - size.width;
    half = Math.min(half, gap - SOCKET);
  }
  return Math.max(0, 2 * half);
}
