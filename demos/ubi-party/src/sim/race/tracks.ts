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

/** An eight, whose bridge leads over its own road. */
const bridge = layTrack({
  id: 'bridge',
  title: 'Figure eight',
  laps: 3,
  halfWidth: 3.8,
  corners: [
    [-2, -2],
    [12, 9],
    [26, 11],
    [32, 0],
    [26, -11],
    [12, -9],
    [-2, 2],
    [-14, 10],
    [-27, 11],
    [-33, 0],
    [-27, -11],
    [-14, -10],
  ],
  boosts: [
    { from: 0.2, to: 0.23 },
    { from: 0.88, to: 0.91 },
  ],
  bridge: { from: 0.47, to: 0.53 },
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
