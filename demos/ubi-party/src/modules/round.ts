import { MAX_SEATS, PACES, WAIT_FOR_LATE_MS, type Seat } from '../sim/index.ts';

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
  /** State to continue from, after the module was restarted. */
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

const isSeat = (value: unknown): value is number =>
  Number.isInteger(value) && (value as number) >= 0 && (value as number) < MAX_SEATS;

const isSeats = (value: unknown): value is number[] =>
  Array.isArray(value) && value.every(isSeat) && new Set(value).size === value.length;

const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

/** Any client may publish on the topic of the plan: other values are ignored. */
export function isRoundPlan(value: unknown): value is RoundPlan {
  if (!isObject(value)) return false;
  const { id, game, seed, seats, startsAtMs, resume, pace = 1 } = value;
  const isResumable =
    resume === undefined ||
    (isObject(resume) && Number.isInteger(resume['step']) && isObject(resume['state']));
  return (
    typeof id === 'string' &&
    typeof game === 'string' &&
    Number.isInteger(seed) &&
    isSeats(seats) &&
    seats.length > 0 &&
    Number.isFinite(startsAtMs) &&
    Object.values<unknown>(PACES).includes(pace) &&
    isResumable
  );
}

export function isRoundSeats(value: unknown): value is RoundSeats {
  if (!isObject(value) || !isObject(value['clients']) || !isSeats(value['bots'])) return false;
  const clients = Object.entries(value['clients']);
  const { delays = {} } = value;
  if (!isObject(delays) || !Object.values(delays).every(isDelay)) return false;
  return clients.every(([seat, id]) => isSeat(Number(seat)) && typeof id === 'string');
}

function isDelay(value: unknown): value is PhoneDelay {
  if (!isObject(value)) return false;
  const { leastMs, mostMs } = value as Record<string, number>;
  return leastMs! >= 0 && leastMs! <= mostMs! && mostMs! <= WAIT_FOR_LATE_MS;
}
