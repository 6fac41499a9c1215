import type { Cancel, Clock } from '@ubii/timing';
import { Deferred } from '../callbacks/deferred.ts';

/** The answer may take so many usual round trips, within these bounds, milliseconds. [CL-42] */
const TRIPS = 4;
const SHORTEST_MS = 1_000;
const MAX_MS = 2_000;
/** A frame that arrives within this time after the probe may have been sent before the link broke, milliseconds. */
const EARLIER_FRAMES_MS = 250;
/** A deadline that comes so much too late was slept through, milliseconds. */
const SLEPT_MS = 500;

/** Dependencies of a probe. */
export interface ProbeOptions {
  readonly clock: Clock;
  /** Asks the master; resolves `answered` with its answer to this question. */
  readonly ask: (answered: Deferred<void>) => void;
  /** The time of a usual answer, milliseconds; `undefined` when unknown. */
  readonly usualTripMs: () => number | undefined;
  /** Nothing came. Called once; the probe has ended. */
  readonly handleDead: (waitedMs: number) => void;
}

/**
 * Makes sure that a link which seems open is. Only the answer to its own question counts: frames that
 * were on their way say nothing about the link now. [CL-42]
 */
export class Probe {
  readonly #options: ProbeOptions;
  #cancelDeadline: Cancel | undefined;
  #heardMs = Number.NEGATIVE_INFINITY;

  constructor(options: ProbeOptions) {
    this.#options = options;
  }

  /** Asks, unless it is asking. */
  start(): void {
    if (this.#cancelDeadline === undefined) this.#ask();
  }

  /** Something came from the master. */
  handleFrame(): void {
    if (this.#cancelDeadline !== undefined) this.#heardMs = this.#options.clock.monotonicMs();
  }

  /** Ends without a verdict; idempotent. */
  cancel(): void {
    this.#cancelDeadline?.();
    this.#cancelDeadline = undefined;
  }

  #ask(): void {
    const { clock, ask, usualTripMs } = this.#options;
    const waitMs = Math.min(MAX_MS, Math.max(SHORTEST_MS, TRIPS * (usualTripMs() ?? 0)));
    const askedMs = clock.monotonicMs();
    const answered = new Deferred<void>();
    const cancelDeadline = clock.after(waitMs, () => this.#handleDeadline(askedMs, waitMs));
    this.#cancelDeadline = cancelDeadline;
    void answered.promise.then(() => {
      if (this.#cancelDeadline === cancelDeadline) this.cancel();
    });
    ask(answered);
  }

  #handleDeadline(askedMs: number, waitMs: number): void {
    const waitedMs = this.#options.clock.monotonicMs() - askedMs;
    const hasSlept = waitedMs > waitMs + SLEPT_MS;
    // The answer waits behind large frames, which came anyway.
    const isAlive = this.#heardMs > askedMs + EARLIER_FRAMES_MS;
    this.#cancelDeadline = undefined;
    if (hasSlept || isAlive) this.#ask();
    else this.#options.handleDead(waitedMs);
  }
}
