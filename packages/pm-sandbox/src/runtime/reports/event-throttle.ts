import type { ModuleEvent } from '@ubii/proto';
import type { Cancel, Clock } from '@ubii/timing';
import { eventKey } from './event-key.ts';

/** Equal events are told once in this time. [PM-81] */
const WINDOW_MS = 1000;

interface Window {
  readonly cancel: Cancel;
  /** The newest event that was left out. */
  latest: ModuleEvent | undefined;
  suppressed: number;
}

/**
 * Lets events pass at once, equal ones once a second. What was left out meanwhile is told at the end
 * of the second, as one event with its number. [PM-81]
 */
export class EventThrottle {
  readonly #clock: Clock;
  readonly #maxDifferent: number;
  readonly #emit: (event: ModuleEvent) => void;
  readonly #windows = new Map<string, Window>();
  /** Events left out because there were too many different ones. */
  #overflow = 0;
  #isClosed = false;

  /** @param maxDifferent different events in a second; what is beyond is only counted */
  constructor(clock: Clock, maxDifferent: number, emit: (event: ModuleEvent) => void) {
    this.#clock = clock;
    this.#maxDifferent = maxDifferent;
    this.#emit = emit;
  }

  push(event: ModuleEvent): void {
    if (this.#isClosed) return this.#emit(event);
    const key = eventKey(event);
    const open = this.#windows.get(key);
    if (open !== undefined) {
      // The one that is told at the end of the window stands for itself.
      if (open.latest !== undefined) open.suppressed++;
      open.latest = event;
      return;
    }
    if (this.#windows.size >= this.#maxDifferent) {
      this.#overflow++;
      return;
    }
    this.#openWindow(key);
    this.#emitCounted(event, 0);
  }

  /** Tells what was left out so far. */
  flush(): void {
    for (const open of this.#windows.values()) {
      const { latest, suppressed } = open;
      open.latest = undefined;
      open.suppressed = 0;
      if (latest !== undefined) this.#emitCounted(latest, suppressed);
    }
  }

  /** Tells what was left out so far; what comes after that passes. */
  close(): void {
    this.#isClosed = true;
    this.flush();
    for (const { cancel } of this.#windows.values()) cancel();
    this.#windows.clear();
  }

  #openWindow(key: string): void {
    const cancel = this.#clock.after(WINDOW_MS, () => this.#endWindow(key));
    this.#windows.set(key, { cancel, latest: undefined, suppressed: 0 });
  }

  #endWindow(key: string): void {
    const ended = this.#windows.get(key);
    this.#windows.delete(key);
    if (ended?.latest === undefined) return;
    this.#openWindow(key);
    this.#emitCounted(ended.latest, ended.suppressed);
  }

  #emitCounted(event: ModuleEvent, suppressed: number): void {
    const overflow = this.#overflow;
    this.#overflow = 0;
    this.#emit({ ...event, suppressed: suppressed + overflow });
  }
}
