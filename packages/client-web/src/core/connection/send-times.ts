import type { Clock } from '@ubii/timing';

/**
 * When registrations and sockets of a client were sent: epoch milliseconds, each more than the one before. What a broken
 * network holds back arrives later than what was sent after it, and must not take the place of that. [EX-51]
 */
export class SendTimes {
  readonly #clock: Pick<Clock, 'nowMs'>;
  #lastMs = 0;

  constructor(clock: Pick<Clock, 'nowMs'>) {
    this.#clock = clock;
  }

  next(): number {
    this.#lastMs = Math.max(this.#clock.nowMs(), this.#lastMs + 1);
    return this.#lastMs;
  }
}
