/** Between 0 and 1. */
export function clamp01(value: number): number {
  return value < 0 ? 0 : value > 1 ? 1 : value;
}

export function mix(from: number, to: number, share: number): number {
  return from + (to - from) * share;
}

/** Slow at both ends. */
export function smooth(share: number): number {
  const t = clamp01(share);
  return t * t * (3 - 2 * t);
}

/** Fast at first: what comes to rest. */
export function easeOut(share: number): number {
  const left = 1 - clamp01(share);
  return 1 - left * left * left;
}

/** Share by which a value nears its goal in this time, whatever the frame rate. @param halfLifeS seconds for half of the way */
export function approach(dtS: number, halfLifeS: number): number {
  return 1 - 0.5 ** (dtS / halfLifeS);
}

/** From 0 to 1 and back, a parabola: a hop. */
export function hop(share: number): number {
  const t = clamp01(share);
  return 4 * t * (1 - t);
}

/** A number from 0 to 1 that only depends on its arguments: scattered, but the same in each run. */
export function scatter(index: number, salt: number): number {
  let hash = Math.imul(index + 1, 0x9e3779b1) ^ Math.imul(salt + 1, 0x85ebca6b);
  hash = Math.imul(hash ^ (hash >>> 15), 0x2c1b3c6d);
  hash = Math.imul(hash ^ (hash >>> 12), 0x297a2d39);
  return ((hash ^ (hash >>> 15)) >>> 0) / 2 ** 32;
}
