import type { PhoneDelay, RoundPlan, RoundSeats } from './round.ts';
import { MAX_SEATS, PACES, WAIT_FOR_LATE_MS } from '../sim/index.ts';

const isSeat = (value: unknown): value is number =>
  Number.isInteger(value) && (value as number) >= 0 && (value as number) < MAX_SEATS;

const isSeats = (value: unknown): value is number[] =>
  Array.isArray(value) && value.every(isSeat) && new Set(value).size === value.length;

const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

/** Anybody may publish on the topic of the plan: what is none is left out. */
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
