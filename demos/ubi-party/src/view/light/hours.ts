/** A colour, `#rrggbb`. */
export type Colour = `#${string}`;

/** The ground and the light of a screen: none of its colours is a player's. */
export interface Hour {
  /** At the bottom of the picture, in its middle, and at the top. */
  readonly ground: Colour;
  readonly middle: Colour;
  readonly horizon: Colour;
  readonly key: { readonly colour: Colour; readonly intensity: number; readonly from: Direction };
  readonly sky: { readonly colour: Colour; readonly bounce: Colour; readonly intensity: number };
  /** Laid on the ground where the key light does not reach. */
  readonly shade: { readonly colour: Colour; readonly opacity: number };
  /** Height of the sun disc's middle and its radius, in heights of the picture, where there is one. */
  readonly sun?: {
    readonly colour: Colour;
    readonly ray: Colour;
    readonly x: number;
    readonly y: number;
    readonly radius: number;
    readonly skyline: number;
  };
}
type Direction = readonly [x: number, y: number, z: number];

const FROM_LEFT: Direction = [-0.62, 0.6, 0.52];

/** The table of the art direction: one toybox, four times of day. */
export const HOURS = {
  /** Late afternoon, low from the left. */
  lobby: {
    ground: '#efcb94',
    middle: '#f2d3a0',
    horizon: '#fae4b6',
    key: { colour: '#ffe6bd', intensity: 3.1, from: [-0.72, 0.52, 0.5] },
    sky: { colour: '#eaf0ff', bounce: '#f3cf95', intensity: 1.35 },
    shade: { colour: '#7d5526', opacity: 0.42 },
  },
  /** Morning, 38 degrees high. */
  race: {
    ground: '#a9c6a3',
    middle: '#b4cfae',
    horizon: '#c3d9bb',
    key: { colour: '#ffeccc', intensity: 3, from: FROM_LEFT },
    sky: { colour: '#eaf0ff', bounce: '#b4cfae', intensity: 1.35 },
    shade: { colour: '#2f5144', opacity: 0.45 },
  },
  /** Evening, one lamp above. */
  hill: {
    ground: '#2c3a63',
    middle: '#3b4670',
    horizon: '#262f55',
    key: { colour: '#fff1d8', intensity: 2.9, from: [-0.42, 0.78, 0.46] },
    sky: { colour: '#b9c9ff', bounce: '#46507f', intensity: 1.15 },
    shade: { colour: '#0a1030', opacity: 0.62 },
  },
  podium: {
    ground: '#e6b56d',
    middle: '#efc88a',
    horizon: '#f4ead0',
    key: { colour: '#ffe6bd', intensity: 3.1, from: [-0.6, 0.58, 0.56] },
    sky: { colour: '#eaf0ff', bounce: '#f3cf95', intensity: 1.3 },
    shade: { colour: '#7d4d1c', opacity: 0.42 },
    sun: { colour: '#f5d689', ray: '#f6e3b4', x: 0.345, y: 0.335, radius: 0.325, skyline: 0.55 },
  },
  /** Noon, flat. */
  duel: {
    ground: '#d9c39c',
    middle: '#e6d6b4',
    horizon: '#cfe3ea',
    key: { colour: '#fff4e2', intensity: 2.9, from: [-0.5, 0.72, 0.5] },
    sky: { colour: '#e4f1ff', bounce: '#e2d3b6', intensity: 1.4 },
    shade: { colour: '#5d4a35', opacity: 0.42 },
  },
} as const satisfies Record<string, Hour>;
