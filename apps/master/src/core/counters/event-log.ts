import { StatusEventKind, type StatusEvent } from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import { oneLine } from '@ubii/words';
import type { Limits } from '../limits/index.ts';
import type { Log } from '../ports/log.ts';

/** Events kept [EX-17]: what a page can show, usually in some 30 KB. */
const KEPT_EVENTS = 200;

/** Events that are logged elsewhere with more details, or that users see without a log. */
const NOT_LOGGED: ReadonlySet<StatusEventKind> = new Set([
  StatusEventKind.MASTER_STARTED,
  StatusEventKind.LIMIT_REACHED,
  StatusEventKind.FILE_CHANGED,
  StatusEventKind.FILE_BROKEN,
]);

/** Recent events, for people [EX-16]. */
export class EventLog {
  readonly #clock: Clock;
  readonly #log: Log;
  readonly #limits: Limits;
  readonly #events: StatusEvent[] = [];

  constructor(clock: Clock, log: Log, limits: Limits) {
    this.#clock = clock;
    this.#log = log;
    this.#limits = limits;
  }

  add(kind: StatusEventKind, text: string, clientId?: string): void {
    const bounded = oneLine(text, this.#limits.eventCharacters); // [EX-72]
    this.#events.push({
      timeMs: this.#clock.nowMs(),
      kind,
      text: bounded,
      clientId: clientId ?? '',
    });
    if (this.#events.length > KEPT_EVENTS) this.#events.shift();
    if (NOT_LOGGED.has(kind)) return;
    this.#log.info(text, clientId === undefined ? {} : { clientId });
  }

  /** Events after this moment, oldest first. */
  since(timeMs: number): StatusEvent[] {
    return this.#events.filter((event) => event.timeMs > timeMs);
  }
}
