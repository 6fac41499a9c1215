import { MAX_SEATS, type Seat } from '../../../sim/index.ts';
import { scatter } from '../../motion/ease.ts';

/** Number of rows and distance between pieces on a table, units. */
export interface LobbyPlan {
  readonly seats: number;
  readonly rows: number;
  readonly columns: number;
  readonly column: number;
  /** Deep enough for a name between two rows. */
  readonly row: number;
  /** Of a piece: the fewer there are, the larger. */
  readonly size: number;
}

const PLANS: readonly LobbyPlan[] = [
  { seats: 8, rows: 2, columns: 4, column: 3.5, row: 5.8, size: 1.34 },
  { seats: 18, rows: 3, columns: 6, column: 3.2, row: 7, size: 1.16 },
  { seats: MAX_SEATS, rows: 4, columns: 8, column: 2.95, row: 7.2, size: 1.04 },
];

/** The smallest table for the highest seat that is taken: who sits keeps the place until the table is full. */
export function lobbyPlan(highest: Seat): LobbyPlan {
  return PLANS.find(({ seats }) => highest < seats) ?? PLANS.at(-1)!;
}

/** Position of a seat: the front row is filled first, rows stand in the gaps of those before them. */
export function lobbySpot(seat: Seat, plan: LobbyPlan): { readonly x: number; readonly z: number } {
  const row = Math.floor(seat / plan.columns);
  const column = seat % plan.columns;
  const shift = row % 2 === 0 ? -0.22 : 0.22;
  return {
    x: (column - (plan.columns - 1) / 2 + shift) * plan.column + (scatter(seat, 1) - 0.5) * 0.3,
    z: -row * plan.row + (scatter(seat, 2) - 0.5) * 0.5,
  };
}

/** Half of the width, and the depth, that pieces cover. */
export function lobbySize(plan: LobbyPlan): { readonly half: number; readonly depth: number } {
  return { half: (plan.columns / 2) * plan.column, depth: (plan.rows - 1) * plan.row };
}
