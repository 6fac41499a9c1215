import type { Cancel } from '@ubii/timing';
import { WATCHDOG_GRACE_MS, WATCHDOG_INTERVAL_MS } from '../sandbox-limits.ts';
import type { Progress } from '../worker/protocol.ts';

/** A call as the watchdog counts it. */
export interface WatchedCall {
  /** Longest it may take in all, its waiting included, milliseconds. */
  readonly waitLimitMs: number;
  /** Looks of the watchdog since it was sent. */
  looks: number;
}

/** The watched call. */
export interface Watched<C extends WatchedCall> {
  isReady(): boolean;
  progress(): Progress;
  /** Batches that were sent. */
  sentBatches(): number;
  calls(): readonly C[];
  /** Longest that the code of an instance may run, milliseconds. */
  limitMs(instance: number): number;
  onVerdict(verdict: Verdict<C>): void;
  /** Nothing is under way any more. */
  onRest(): void;
}

/** Findings of the watchdog. */
export type Verdict<C> =
  /** The worker never began to run. */
  | { readonly kind: 'start' }
  /** The code of an instance does not end. */
  | { readonly kind: 'loop'; readonly instance: number }
  /** No instance runs, and yet the worker takes no message. */
  | { readonly kind: 'deaf' }
  /** A call waits too long. */
  | { readonly kind: 'wait'; readonly call: C };

/** A worker that has not begun to run by then never will, milliseconds. */
const START_TIMEOUT_MS = 30_000;
/**
 * Time for which a worker may process no message while no instance runs, milliseconds. No instance is in a loop then;
 * on a busy computer it just gets no CPU time, and ending it would cost all its instances their state.
 */
const DEAF_TIMEOUT_MS = 5_000;
/** A call that gets no CPU time is ended after this many times its limit: it may also block without computing. */
const MAX_STARVED_LIMITS = 10;

/**
 * Looks at a worker again and again while calls are under way. It counts its looks, not time: a
 * program that was held up itself sees one late look, and does not blame its workers.
 */
export class Watchdog<C extends WatchedCall> {
  readonly #watched: Watched<C>;
  readonly #every: (intervalMs: number, fn: () => void) => Cancel;
  readonly #cpuMs: (() => number) | undefined;
  /** CPU time of the program when what is seen now was first seen, milliseconds. */
  #cpuAtChangeMs = 0;
  #stop: Cancel | undefined;
  #seen: Progress = { received: -1, running: 0, sequence: -1 };
  /** Looks that saw the same. */
  #looks = 0;

  /**
   * @param cpuMs CPU time of the program, milliseconds, at least that of its workers: the code of an instance that got no
   *   CPU time on a busy machine does not loop. Left out where it is not known.
   */
  constructor(
    watched: Watched<C>,
    every: (intervalMs: number, fn: () => void) => Cancel,
    cpuMs?: () => number,
  ) {
    this.#watched = watched;
    this.#every = every;
    this.#cpuMs = cpuMs;
  }

  /** @returns whether it was not watching before */
  start(): boolean {
    if (this.#stop !== undefined) return false;
    this.#looks = 0;
    this.#stop = this.#every(WATCHDOG_INTERVAL_MS, () => this.#look());
    return true;
  }

  stop(): void {
    this.#stop?.();
    this.#stop = undefined;
  }

  #look(): void {
    const watched = this.#watched;
    const calls = watched.calls();
    // Not when the last call ends: starting and stopping a timer costs as much as a call.
    if (calls.length === 0 && watched.isReady()) {
      this.stop();
      watched.onRest();
      return;
    }
    const now = watched.progress();
    const silentMs = this.#silentMs(now);
    if (!watched.isReady()) {
      if (silentMs > START_TIMEOUT_MS) watched.onVerdict({ kind: 'start' });
      return;
    }
    const { running, received } = now;
    if (running !== 0 && this.#isLoop(silentMs, watched.limitMs(running))) {
      watched.onVerdict({ kind: 'loop', instance: running });
      return;
    }
    const isDeaf = running === 0 && received < watched.sentBatches();
    if (isDeaf && silentMs >= DEAF_TIMEOUT_MS + WATCHDOG_GRACE_MS) {
      watched.onVerdict({ kind: 'deaf' });
      return;
    }
    for (const call of calls) {
      call.looks++;
      if (call.looks * WATCHDOG_INTERVAL_MS >= call.waitLimitMs) {
        watched.onVerdict({ kind: 'wait', call });
      }
    }
  }

  #isLoop(silentMs: number, limitMs: number): boolean {
    if (silentMs < limitMs + WATCHDOG_GRACE_MS) return false;
    const hasComputed = this.#cpuMs === undefined || this.#cpuMs() - this.#cpuAtChangeMs >= limitMs;
    return hasComputed || silentMs >= MAX_STARVED_LIMITS * limitMs;
  }

  /** Returns the time without progress, milliseconds. */
  #silentMs(now: Progress): number {
    const { received, running, sequence } = this.#seen;
    const isSame =
      received === now.received && running === now.running && sequence === now.sequence;
    this.#looks = isSame ? this.#looks + 1 : 0;
    if (!isSame) this.#cpuAtChangeMs = this.#cpuMs?.() ?? 0;
    this.#seen = now;
    return this.#looks * WATCHDOG_INTERVAL_MS;
  }
}
