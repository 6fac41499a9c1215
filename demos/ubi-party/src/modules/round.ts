import type { Seat } from '../sim/index.ts';

/** The round that a module is to play: JSON at its input `round`. */
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

/**
 * Assignment of clients to seats: JSON at the input `seats`. A seat without a client that is not a bot's is at rest.
 */
export interface RoundSeats {
  /** Client ids of those who are present, by seat. */
  readonly clients: Readonly<Record<Seat, string>>;
  readonly bots: readonly Seat[];
  /** Measured delays of the phones, by seat; seats without a measurement are missing. */
  readonly delays?: Readonly<Record<Seat, PhoneDelay>>;
}

/** Bounds of the delay between the time claimed by a phone and the arrival of its record, milliseconds. */
export interface PhoneDelay {
  readonly leastMs: number;
  readonly mostMs: number;
}

/** State of the round: JSON at the module's output `state`. */
export interface RoundState<State = unknown> {
  readonly id: string;
  /** Steps since the start. */
  readonly step: number;
  readonly state: State;
  readonly places: readonly (readonly Seat[])[];
  readonly isOver: boolean;
}
