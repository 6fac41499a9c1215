import type { OwnPicture } from './picture.ts';

type Point = readonly [number, number];

/**
 * Keypoints of an open hand with its palm towards the camera, fingers upwards and the thumb at the left, in
 * the order of `HAND_KEYPOINTS`; 0 to 1 of a square.
 */
export const HAND_POINTS: readonly Point[] = [
  [0.5, 0.95],
  ...([
    [0.36, 0.88],
    [0.25, 0.78],
    [0.17, 0.69],
    [0.1, 0.61],
  ] as const),
  ...([
    [0.36, 0.55],
    [0.32, 0.38],
    [0.3, 0.27],
    [0.28, 0.17],
  ] as const),
  ...([
    [0.48, 0.52],
    [0.47, 0.33],
    [0.47, 0.2],
    [0.47, 0.09],
  ] as const),
  ...([
    [0.59, 0.54],
    [0.62, 0.37],
    [0.63, 0.25],
    [0.65, 0.15],
  ] as const),
  ...([
    [0.69, 0.6],
    [0.75, 0.48],
    [0.78, 0.4],
    [0.82, 0.32],
  ] as const),
];

/** Half the width of fingers, from the thumb on, of the palm, and of the arm. */
const FINGERS = [0.075, 0.06, 0.062, 0.058, 0.05];
const PALM = 0.11;
const ARM = 0.14;

/** Round bars between two points: fingers, palm and arm. */
const BARS: readonly { from: Point; to: Point; radius: number }[] = [
  ...FINGERS.flatMap((radius, finger) => {
    const first = 1 + finger * 4;
    const joints = [0, 1, 2].map((joint) => ({
      from: HAND_POINTS[first + joint]!,
      to: HAND_POINTS[first + joint + 1]!,
      radius: joint === 2 ? radius * 0.85 : radius,
    }));
    const root = { from: HAND_POINTS[0]!, to: HAND_POINTS[first]! };
    return [...joints, { ...root, radius: finger === 0 ? radius : PALM }];
  }),
  { from: HAND_POINTS[0]!, to: [0.5, 1.6], radius: ARM },
];

const SKIN = [235, 180, 150];

/**
 * Draws a lit hand on a grey background.
 *
 * @param hand top left corner and side of its square, in pixels; mirrored, its thumb is at the right
 */
export function handPicture(
  width: number,
  height: number,
  hand: { x: number; y: number; side: number; isMirrored?: boolean },
): OwnPicture {
  const heights = new Float32Array(width * height);
  for (let pixel = 0; pixel < heights.length; pixel++) {
    const along = ((pixel % width) + 0.5 - hand.x) / hand.side;
    const place: Point = [
      hand.isMirrored === true ? 1 - along : along,
      (Math.floor(pixel / width) + 0.5 - hand.y) / hand.side,
    ];
    for (const { from, to, radius } of BARS) {
      const square = radius ** 2 - distanceSquared(place, from, to);
      if (square > 0) heights[pixel] = Math.max(heights[pixel]!, Math.sqrt(square) * hand.side);
    }
  }
  const data = new Uint8Array(width * height * 3);
  for (let pixel = 0; pixel < heights.length; pixel++) {
    const isHand = heights[pixel]! > 0;
    // The slope to the next pixels says how the surface is turned to a light from the upper left.
    const dx = heights[pixel]! - (heights[pixel + 1] ?? 0);
    const dy = heights[pixel]! - (heights[pixel + width] ?? 0);
    const light = Math.max(0.3, (0.82 - 0.35 * dx - 0.45 * dy) / Math.hypot(dx, dy, 1));
    for (let channel = 0; channel < 3; channel++) {
      data[pixel * 3 + channel] = isHand ? Math.min(255, SKIN[channel]! * light) : 110;
    }
  }
  return { width, height, format: 'RGB8', data };
}

function distanceSquared([x, y]: Point, [ax, ay]: Point, [bx, by]: Point): number {
  const [dx, dy] = [bx - ax, by - ay];
  const share = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx ** 2 + dy ** 2)));
  return (x - ax - share * dx) ** 2 + (y - ay - share * dy) ** 2;
}
