import { hop } from './ease.ts';

const FROM_Y = 10;
const GRAVITY = 44;
/** Seconds until it touches the table. */
export const FALL_S = Math.sqrt((2 * FROM_Y) / GRAVITY);
const BOUNCE = { lastsS: 0.36, height: 0.8 } as const;
/** From here on it stands still. */
export const DROP_S = FALL_S + BOUNCE.lastsS;

/** Height of a piece that joins: it drops in, bounces once, and stands. @param sinceS seconds since it came */
export function dropHeight(sinceS: number): number {
  if (sinceS <= 0) return FROM_Y;
  if (sinceS < FALL_S) return FROM_Y - (GRAVITY * sinceS * sinceS) / 2;
  return hop((sinceS - FALL_S) / BOUNCE.lastsS) * BOUNCE.height;
}

/** Whether it touches the table between two times. */
export function touchesDown(beforeS: number, nowS: number): boolean {
  return [FALL_S, DROP_S].some((at) => beforeS < at && nowS >= at);
}
