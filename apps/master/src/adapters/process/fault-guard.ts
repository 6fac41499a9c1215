import type { Log } from '../../core/ports/index.ts';

/** More faults than this within the window mean that going on makes no sense. */
const MAX_FAULTS = 10;
const WINDOW_MS = 10_000;

/**
 * Keeps the process alive after an uncaught error. This is safe here: every way into the core
 * catches what goes wrong in it, so what arrives here broke off one connection or one request, and
 * state of others is not half changed. Errors that keep coming end the process in good order.
 */
export class FaultGuard {
  readonly #log: Log;
  readonly #giveUp: () => void;
  #times: number[] = [];

  /** @param giveUp ends the process */
  constructor(log: Log, giveUp: () => void) {
    this.#log = log;
    this.#giveUp = giveUp;
  }

  /** @param kind what the process calls it @param nowMs any clock */
  handle(kind: string, thrown: unknown, nowMs: number): void {
    const error = thrown instanceof Error ? thrown : new Error(String(thrown));
    this.#log.error(`${kind}: please report this`, { reason: error.message, stack: error.stack });
    this.#times = [...this.#times.filter((time) => nowMs - time < WINDOW_MS), nowMs];
    if (this.#times.length <= MAX_FAULTS) return;
    this.#log.error(
      `more than ${MAX_FAULTS} such errors within ${WINDOW_MS / 1000} s: the master exits`,
    );
    this.#giveUp();
  }
}
