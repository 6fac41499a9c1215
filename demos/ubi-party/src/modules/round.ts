import type { Seat } from '../sim/index.ts';

/** What a module is told to play: JSON at its input `round`. */
export interface RoundPlan {
  /** Another id is another round. */
  readonly id: string;
  /** Modules of other games leave it alone: the plan of the round before is still there when theirs starts. */
  readonly game: string;
  readonly seed: number;
  readonly seats: readonly Seat[];
  /** Times to answer are so many times as long, 1 to 2. @default 1 */
  readonly pace?: number;
  /** When the first step is, milliseconds since the Unix epoch, master's clock. */
  readonly startsAtMs: number;
  /** The state to go on from, after the module was started again. */
  readonly resume?: { readonly step: number; readonly state: unknown };
}

/** Who plays on which seat: JSON at the input `seats`. Seats without a client that are no bots' are at rest. */
export interface RoundSeats {
  /** Client ids of those who are present, by seat. */
  readonly clients: Readonly<Record<Seat, string>>;
  readonly bots: readonly Seat[];
  /** What the way from each phone takes, by seat; those that are missing were not measured. */
  readonly delays?: Readonly<Record<Seat, PhoneDelay>>;
}

/** How much later than its phone says something may arrive, milliseconds. */
export interface PhoneDelay {
  readonly leastMs: number;
  readonly mostMs: number;
}

/** What a module says of the round: JSON at its output `state`. */
export interface RoundState<State = unknown> {
  readonly id: string;
  /** Steps since the start. */
  readonly step: number;
  readonly state: State;
  readonly places: readonly (readonly Seat[])[];
  readonly isOver: boolean;
}
