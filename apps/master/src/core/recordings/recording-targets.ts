import type { LimitWatch } from '../counters/limit-watch.ts';

/** The first target of recordings; that before is the flight recorder's. */
const FIRST_TARGET = 2;

/** Bits by which the recorder tells running recordings apart. */
export class RecordingTargets {
  readonly #limits: LimitWatch;
  /** Targets of recordings that are started and are in no state of the recorder yet. */
  readonly #starting = new Set<number>();
  #running = 0;

  constructor(limits: LimitWatch) {
    this.#limits = limits;
  }

  /** Returns a free target, held until `endStart`. @throws ServiceError when as many run as may */
  beginStart(): number {
    const max = this.#limits.limits.runningRecordings;
    const used = [...this.#starting].reduce((bits, target) => bits | target, this.#running);
    for (let index = 0; index < max; index++) {
      const target = FIRST_TARGET << index;
      if ((used & target) !== 0) continue;
      this.#starting.add(target);
      return target;
    }
    throw this.#limits.refusal('runningRecordings', `more than ${max} recordings at once`);
  }

  /** The recorder knows the recording now, or it did not start. */
  endStart(target: number): void {
    this.#starting.delete(target);
  }

  /** Takes the targets that run now. Returns those that have ended. */
  update(running: number): number[] {
    const ended = this.#running & ~running;
    this.#running = running;
    const targets: number[] = [];
    for (let target = FIRST_TARGET; target <= ended; target <<= 1) {
      if ((ended & target) !== 0) targets.push(target);
    }
    return targets;
  }
}
