import type { PreciseClock } from '@ubii/timing';
import { SystemClock } from '@ubii/timing/system';
import type { Log } from '../../core/ports/index.ts';

/**
 * The system's time of day with fractions of a millisecond, which JavaScript does not tell: the
 * monotonic clock goes on from a tick of the system's clock, and is led back when it leaves the
 * millisecond the system is in. So it follows a clock that is set or corrected, at the latest a
 * millisecond later.
 */
export class FineTime {
  readonly #wholeMs: () => number;
  readonly #monotonicMs: () => number;
  #baseMs: number | undefined;

  /**
   * @param wholeMs the system's time in whole milliseconds
   * @param monotonicMs with fractions
   */
  constructor(wholeMs: () => number, monotonicMs: () => number) {
    this.#wholeMs = wholeMs;
    this.#monotonicMs = monotonicMs;
  }

  /** Milliseconds since the Unix epoch. The first call waits for a tick, a millisecond at most. */
  nowMs(): number {
    this.#baseMs ??= this.#findTick();
    const wholeMs = this.#wholeMs();
    const nowMs = this.#baseMs + this.#monotonicMs();
    if (nowMs < wholeMs) this.#baseMs += wholeMs - nowMs;
    else if (nowMs >= wholeMs + 1) this.#baseMs -= nowMs - (wholeMs + LAST_OF_MILLISECOND);
    else return nowMs;
    return nowMs < wholeMs ? wholeMs : wholeMs + LAST_OF_MILLISECOND;
  }

  #findTick(): number {
    const startMs = this.#wholeMs();
    const giveUpMs = this.#monotonicMs() + 2;
    let wholeMs = startMs;
    while (wholeMs === startMs && this.#monotonicMs() < giveUpMs) wholeMs = this.#wholeMs();
    return wholeMs - this.#monotonicMs();
  }
}

/** Fractions of an epoch time are exact to a quarter of a microsecond. */
const LAST_OF_MILLISECOND = 0.999;

/** The clock and the event loop of this process. A callback that throws is logged and nothing else suffers. */
export class PreciseSystemClock extends SystemClock implements PreciseClock {
  readonly #fine = new FineTime(Date.now, () => performance.now());

  constructor(log: Log) {
    super({
      // The check phase follows the poll phase: every socket that had input in this turn was read.
      endTurn: (fn) => void setImmediate(fn),
      handleError: (error) =>
        log.error('a timed task failed', { reason: String(error), stack: stackOf(error) }),
    });
  }

  preciseMs(): number {
    return this.#fine.nowMs();
  }
}

function stackOf(error: unknown): string | undefined {
  return error instanceof Error ? error.stack : undefined;
}
