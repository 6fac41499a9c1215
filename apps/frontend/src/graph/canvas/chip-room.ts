import type { Point, Wire } from '../model/graph.ts';
import type { CanvasStage } from './canvas-stage.ts';

/** Largest width of a chip, pixels at a zoom of 1. */
export const MAX_CHIP = 220;
/** Half of the height of a chip with padding, pixels. */
const HALF_HEIGHT = 14;
/** Distance by which sockets extend beyond the edge of a node, pixels. */
const SOCKET = 14;

type Drawn = Pick<CanvasStage, 'positions' | 'sizes'>;

/**
 * Returns the largest width of a wire's chip that covers no socket of the nodes at its ends, pixels.
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

/** Width of a chip with its rate, with the age of its last record, and with chart and value, pixels. */
const RATE_PX = 62;
const AGE_PX = 72;
const BESIDE_PX = 104;
/** Width of the mark of a problem, pixels. */
const MARK_PX = 18;

/** What a chip has room for beside the mark of a problem: less is shown instead of a cut text. */
export interface ChipParts {
  readonly rate: boolean;
  readonly age: boolean;
  /** Chart and value. */
  readonly beside: boolean;
}

/** Returns what a chip of this width has room for, pixels. */
export function chipParts(width: number, isWrong: boolean): ChipParts {
  const room = isWrong ? width - MARK_PX : width;
  return { rate: room >= RATE_PX, age: room >= AGE_PX, beside: room >= BESIDE_PX };
}
