import { isPace } from '../../sim/index.ts';
import type { PhoneRequest, PhoneWish } from '../messages.ts';

const MAX_CHARACTERS = 1000;

/** Parses a request of a phone; undefined if invalid: any client that has joined may publish any text. */
export function parseRequest(text: string): PhoneRequest | undefined {
  if (text.length > MAX_CHARACTERS) return undefined;
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    return undefined;
  }
  if (!isObject(value) || !Number.isSafeInteger(value['number'])) return undefined;
  const wish = parseWish(value['wish']);
  return wish && { number: value['number'] as number, wish };
}

function parseWish(value: unknown): PhoneWish | undefined {
  if (!isObject(value)) return undefined;
  const check = CHECKS[value['type'] as PhoneWish['type']];
  // Object.hasOwn: `constructor` is no wish
  if (!Object.hasOwn(CHECKS, String(value['type'])) || !check(value)) return undefined;
  return value as unknown as PhoneWish;
}

type Check = (wish: Record<string, unknown>) => boolean;
const text =
  (member: string): Check =>
  (wish) =>
    typeof wish[member] === 'string';
const flag =
  (member: string): Check =>
  (wish) =>
    typeof wish[member] === 'boolean';
const whole =
  (member: string): Check =>
  (wish) =>
    Number.isSafeInteger(wish[member]);
const nothing: Check = () => true;

const CHECKS: Record<PhoneWish['type'], Check> = {
  join: text('name'),
  watch: text('name'),
  leave: nothing,
  away: nothing,
  back: nothing,
  ready: flag('isReady'),
  offer: nothing,
  take: text('code'),
  proceed: nothing,
  kick: whole('seat'),
  lead: whole('seat'),
  dismiss: text('key'),
  lock: flag('on'),
  'hide-code': flag('on'),
  'set-teams': whole('teams'),
  'set-pace': ({ pace }) => isPace(pace),
  'set-games': ({ games }) =>
    Array.isArray(games) && games.length <= 12 && games.every((game) => typeof game === 'string'),
  fill: whole('players'),
};

const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);
