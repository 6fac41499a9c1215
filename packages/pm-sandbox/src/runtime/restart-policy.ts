import type { RuntimeLimits } from '../limits.ts';

type RestartLimits = Pick<
  RuntimeLimits,
  'maxRestarts' | 'restartWindowMs' | 'restartDelayMs' | 'maxRestartDelayMs'
>;

/** Says when a killed instance is created again, and when it is given up. [PM-54] */
export class RestartPolicy {
  readonly #limits: RestartLimits;
  /** When restarts were granted, monotonic milliseconds, oldest first. */
  #grantedMs: number[] = [];

  constructor(limits: RestartLimits) {
    this.#limits = limits;
  }

  /**
   * Asks for one more restart.
   *
   * @param nowMs monotonic milliseconds
   * @returns milliseconds to wait before it, or undefined when there were too many
   */
  next(nowMs: number): number | undefined {
    const { maxRestarts, restartWindowMs, restartDelayMs, maxRestartDelayMs } = this.#limits;
    this.#grantedMs = this.#grantedMs.filter((grantedMs) => nowMs - grantedMs < restartWindowMs);
    const count = this.#grantedMs.length;
    if (count >= maxRestarts) return undefined;
    this.#grantedMs.push(nowMs);
    return Math.min(restartDelayMs * 2 ** count, maxRestartDelayMs);
  }
}
