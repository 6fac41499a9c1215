import type { Cancel, Clock, Log } from '../../core/ports/index.ts';
import { FineTime } from './fine-time.ts';

/** The clock and the event loop of this process. A callback that throws is logged and nothing else suffers. */
export class SystemClock implements Clock {
  readonly #log: Log;
  readonly #fine = new FineTime(Date.now, () => performance.now());

  constructor(log: Log) {
    this.#log = log;
  }

  nowMs(): number {
    return Date.now();
  }

  preciseMs(): number {
    return this.#fine.nowMs();
  }

  monotonicMs(): number {
    return performance.now();
  }

  every(intervalMs: number, fn: () => void): Cancel {
    const timer = setInterval(this.#guard, intervalMs, fn);
    return () => clearInterval(timer);
  }

  after(delayMs: number, fn: () => void): Cancel {
    const timer = setTimeout(this.#guard, delayMs, fn);
    return () => clearTimeout(timer);
  }

  // The check phase follows the poll phase: every socket that had input in this turn was read.
  atEndOfTurn(fn: () => void): void {
    setImmediate(this.#guard, fn);
  }

  readonly #guard = (fn: () => void): void => {
    try {
      fn();
    } catch (error) {
      this.#log.error('a timed task failed', { reason: String(error), stack: stackOf(error) });
    }
  };
}

function stackOf(error: unknown): string | undefined {
  return error instanceof Error ? error.stack : undefined;
}
