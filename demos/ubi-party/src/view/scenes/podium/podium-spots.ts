import type { Seat } from '../../../sim/index.ts';

/** A step of the podium: place, middle, size, units. */
export interface PodiumStep {
  readonly place: 1 | 2 | 3;
  readonly x: number;
  readonly width: number;
  readonly height: number;
  readonly trim: string;
}

export const STEP_DEPTH = 3;
/** From left to right as they stand; the first in the middle. So high that the digits are above the heads of a crowd. */
export const STEPS: readonly PodiumStep[] = [
  { place: 2, x: -4.1, width: 4, height: 4.2, trim: '#dcd9d2' },
  { place: 1, x: 0, width: 4, height: 5.4, trim: '#f0b62c' },
  { place: 3, x: 4.1, width: 4, height: 3.4, trim: '#d98d58' },
];

/** Pieces per row before the steps. */
const ROW_OF_OTHERS = 10;
/** The camera looks far less down than in the lobby: rows that are nearer hide letters. */
const ROW_OF_OTHERS_Z = 5.4;
/** The first row before the steps. */
const CROWD_Z = 4.2;
/** As few stand between the digits. */
const BETWEEN_DIGITS = [-2.05, 2.05, 7.4] as const;

export interface PodiumSpot {
  readonly seat: Seat;
  /** From 1; 0 for the others. */
  readonly place: number;
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly size: number;
}

/** The first three on their steps, the others in rows before them. */
export function podiumSpots(seats: readonly Seat[], first: readonly Seat[]): PodiumSpot[] {
  const winners = first.slice(0, STEPS.length).filter((seat) => seats.includes(seat));
  const others = seats.filter((seat) => !winners.includes(seat));
  // Few stand between the digits, many before them
  const isCrowd = others.length > BETWEEN_DIGITS.length;
  const rows = Math.ceil(others.length / ROW_OF_OTHERS);
  const perRow = Math.ceil(others.length / Math.max(1, rows));
  const gap = Math.min(3.3, 15 / Math.max(1, perRow));
  const size = Math.min(1, gap / 2.2);
  return [
    ...winners.map((seat, index) => {
      const step = STEPS.find(({ place }) => place === index + 1)!;
      return { seat, place: index + 1, x: step.x, y: step.height, z: 0, size: 1.28 };
    }),
    ...others.map((seat, index) => {
      const [row, column] = [Math.floor(index / perRow), index % perRow];
      const inRow = Math.min(perRow, others.length - row * perRow);
      return {
        seat,
        place: 0,
        x: !isCrowd
          ? BETWEEN_DIGITS[index]!
          : 1.3 + (column - (inRow - 1) / 2) * gap + (row % 2 === 0 ? 0 : gap * 0.25),
        y: 0,
        z: STEP_DEPTH / 2 + (isCrowd ? CROWD_Z : 1.3) + row * ROW_OF_OTHERS_Z * size,
        size,
      };
    }),
  ];
}
