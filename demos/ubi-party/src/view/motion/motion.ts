import { STEPS_PER_SECOND } from '../../sim/index.ts';

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

/** A value on a damped spring: default stiffness 180, damping 14. */
export class Spring {
  value: number;
  speed = 0;
  readonly #stiffness: number;
  readonly #damping: number;

  constructor(value: number, stiffness = 180, damping = 14) {
    this.value = value;
    this.#stiffness = stiffness;
    this.#damping = damping;
  }

  /** Advances by a time, in parts that are short enough to be stable. */
  step(goal: number, dtS: number): number {
    const parts = Math.max(1, Math.ceil(dtS * 120));
    const part = Math.min(dtS, 0.25) / parts;
    for (let index = 0; index < parts; index += 1) {
      this.speed += ((goal - this.value) * this.#stiffness - this.speed * this.#damping) * part;
      this.value += this.speed * part;
    }
    return this.value;
  }

  /** Without motion. */
  set(value: number): void {
    this.value = value;
    this.speed = 0;
  }
}

const STEP_MS = 1000 / STEPS_PER_SECOND;
/** A state that comes so much too early or too late is a jump (a replay, a pause, a new round), not jitter. */
const JUMP_MS = 100;
/** Share by which each state corrects the clock: jitter of single frames is averaged out. */
const CORRECTION = 0.1;

/** Estimates how far the time of a frame is from the newest state, so that motion is even when states arrive unevenly. */
export class StepClock {
  #step = 0;
  /** Estimated time of step 0, milliseconds. */
  #originMs: number | undefined;

  /** A state of this step has come. */
  take(step: number, nowMs: number): void {
    const originMs = nowMs - step * STEP_MS;
    const isJump =
      this.#originMs === undefined ||
      step < this.#step ||
      Math.abs(originMs - this.#originMs) > JUMP_MS;
    this.#originMs = isJump
      ? originMs
      : this.#originMs! + (originMs - this.#originMs!) * CORRECTION;
    this.#step = step;
  }

  /** Seconds from the newest state to what is drawn now, at most one step before or after it. */
  aheadS(nowMs: number): number {
    if (this.#originMs === undefined) return 0;
    const steps = (nowMs - this.#originMs) / STEP_MS - this.#step;
    return Math.min(1, Math.max(-1, steps)) / STEPS_PER_SECOND;
  }
}
