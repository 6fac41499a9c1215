import type { PreciseClock } from '@ubii/timing';
import { SystemClock } from '@ubii/timing/system';
import type { Log } from '../../core/ports/index.ts';
import { FineTime } from './fine-time.ts';

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
