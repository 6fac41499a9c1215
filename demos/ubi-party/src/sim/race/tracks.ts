import { layTrack, type Track } from './track.ts';

/** A round for the first time: wide, no crossing. */
const garden = layTrack({
  id: 'garden',
  title: 'Garden loop',
  laps: 3,
  halfWidth: 4.2,
  corners: [
    [-14, -15],
    [8, -16],
    [26, -12],
    [30, 2],
    [20, 12],
    [6, 8],
    [-8, 14],
    [-26, 12],
    [-30, -2],
  ],
  boosts: [
    { from: 0.1, to: 0.13 },
    { from: 0.62, to: 0.65 },
  ],
});

/** An eight, whose bridge leads over its own road; the grid is at the front left, where nothing hides it. */
const bridge = layTrack({
  id: 'bridge',
  title: 'Figure eight',
  laps: 3,
  halfWidth: 3.8,
  corners: [
    [-14, -13],
    [-2, -2.5],
    [12, 11.5],
    [26, 14],
    [32.5, 0],
    [26, -14],
    [12, -11.5],
    [-2, 2.5],
    [-14, 13],
    [-27, 14],
    [-33.5, 0],
    [-27, -14],
  ],
  boosts: [
    { from: 0.025, to: 0.053 },
    { from: 0.28, to: 0.308 },
  ],
  bridge: { from: 0.58, to: 0.64 },
});

/** Narrow, with bends in both directions. */
const workshop = layTrack({
  id: 'workshop',
  title: 'Workshop bends',
  laps: 3,
  halfWidth: 3.4,
  corners: [
    [-22, -17],
    [2, -19],
    [24, -18],
    [31, -9],
    [24, 4],
    [14, 6],
    [8, 10],
    [-1, 20],
    [-10, 19],
    [-19, 10],
    [-24, 5],
    [-31, -9],
  ],
  boosts: [
    { from: 0.06, to: 0.09 },
    { from: 0.72, to: 0.745 },
  ],
});

export const TRACKS: readonly Track[] = [garden, bridge, workshop];
