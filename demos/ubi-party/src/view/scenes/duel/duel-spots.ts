import type { Seat } from '../../../sim/index.ts';

/** From so many on, there are two rows. */
const TWO_ROWS = 9;
const ROW_Z = 4.4;

export interface DuelSpot {
  readonly seat: Seat;
  readonly x: number;
  readonly z: number;
}

/** One row, or two of which the second stands in the gaps of the first; the flag is behind them. */
export function duelSpots(seats: readonly Seat[]): DuelSpot[] {
  const rows = seats.length < TWO_ROWS ? 1 : 2;
  const perRow = Math.ceil(seats.length / rows);
  const gap = Math.max(2.5, Math.min(4, 20 / perRow));
  return seats.map((seat, index) => {
    const [row, column] = [Math.floor(index / perRow), index % perRow];
    const inRow = row === 0 ? perRow : seats.length - perRow;
    const offset = (perRow - inRow) % 2 === 0 && row === 1 ? gap / 2 : 0;
    return { seat, x: (column - (inRow - 1) / 2) * gap + offset, z: -row * ROW_Z };
  });
}
