import type { StatusEvent, StatusEventKind } from '@ubii/proto';
import type { Clock } from '../ports/clock.ts';

/** Events kept [EX-17]: what a page can show, in some 30 KB. */
const KEPT_EVENTS = 200;

/** What happened lately, for people [EX-16]. */
export class EventLog {
  readonly #clock: Clock;
  readonly #events: StatusEvent[] = [];

  constructor(clock: Clock) {
    this.#clock = clock;
  }

  add(kind: StatusEventKind, text: string, clientId = ''): void {
    this.#events.push({ timeMs: this.#clock.nowMs(), kind, text, clientId });
    if (this.#events.length > KEPT_EVENTS) this.#events.shift();
  }

  /** Events after this moment, oldest first. */
  since(timeMs: number): StatusEvent[] {
    return this.#events.filter((event) => event.timeMs > timeMs);
  }
}
