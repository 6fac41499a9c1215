import type { Shape } from '../sim/index.ts';

export interface ShapeDrawing {
  /** In a square from -50 to 50. */
  readonly path: string;
  /** A stroke of the same paint rounds the corners. */
  readonly rounding: number;
  /** Centre and height of the letter. */
  readonly letter: { readonly x: number; readonly y: number; readonly size: number };
}

const disc = (x: number, y: number, r: number): string =>
  `M${x - r} ${y}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0z`;
const MIDDLE = { x: 0, y: 0, size: 52 };

/** Petals at every 60 degrees. */
const PETALS = [
  [27, 0],
  [13.5, 23.4],
  [-13.5, 23.4],
  [-27, 0],
  [-13.5, -23.4],
  [13.5, -23.4],
] as const;

export const SHAPE_DRAWINGS: Readonly<Record<Shape, ShapeDrawing>> = {
  circle: { path: disc(0, 0, 46), rounding: 0, letter: MIDDLE },
  triangle: {
    path: 'M0 -37L40 35H-40z',
    rounding: 15,
    letter: { x: 0, y: 14, size: 40 },
  },
  square: { path: 'M-36 -36H36V36H-36z', rounding: 14, letter: MIDDLE },
  star: {
    path: 'M0 -43L13 -16L42 -12L21 9L26 38L0 24L-26 38L-21 9L-42 -12L-13 -16z',
    rounding: 9,
    letter: { x: 0, y: 3, size: 36 },
  },
  diamond: { path: 'M0 -42L40 0L0 42L-40 0z', rounding: 9, letter: { x: 0, y: 0, size: 42 } },
  cross: {
    path: 'M-18 -42H18V-18H42V18H18V42H-18V18H-42V-18H-18z',
    rounding: 8,
    letter: { x: 0, y: 0, size: 46 },
  },
  hexagon: { path: 'M0 -43L37 -21V21L0 43L-37 21V-21z', rounding: 9, letter: MIDDLE },
  drop: {
    path: 'M0 -46C13 -24 36 -8 36 13A36 36 0 0 1 -36 13C-36 -8 -13 -24 0 -46z',
    rounding: 5,
    letter: { x: 0, y: 12, size: 44 },
  },
  ring: {
    path: `${disc(0, 0, 48)}${disc(0, 0, 31)}`,
    rounding: 0,
    letter: { x: 0, y: 0, size: 40 },
  },
  moon: {
    path: 'M8 -44A45 45 0 1 0 44 10A28 28 0 0 1 8 -44z',
    rounding: 5,
    letter: { x: -11, y: 8, size: 42 },
  },
  flower: {
    path: [disc(0, 0, 24), ...PETALS.map(([x, y]) => disc(x, y, 20))].join(''),
    rounding: 0,
    letter: { x: 0, y: 0, size: 44 },
  },
  heart: {
    path: 'M0 41C-62 2 -44 -40 -20 -40C-9 -40 -2 -33 0 -25C2 -33 9 -40 20 -40C44 -40 62 2 0 41z',
    rounding: 4,
    letter: { x: 0, y: -4, size: 40 },
  },
};
