import { STEPS_PER_SECOND } from '../../sim/index.ts';

const STEP_MS = 1000 / STEPS_PER_SECOND;
/** A state that comes so much too early or too late is a jump (a replay, a pause, a new round), not jitter. */
const JUMP_MS = 100;
/** Share by which each state corrects the clock: jitter of single frames is averaged out. */
const CORRECTION = 0.1;

/** Tells how far the time of a frame is from the newest state, so that motion is even although states come unevenly. */
export class StepClock {
  #step = 0;
  /** When step 0 was, as far as can be told, milliseconds. */
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
