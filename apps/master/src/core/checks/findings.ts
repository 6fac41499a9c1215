import { StatusEventKind } from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import type { EventLog } from '../counters/event-log.ts';
import type { Problem } from './problem.ts';

/** Looks in a row that find something before it is a problem [EX-45]. */
const LOOKS_BEFORE = 3;
/** Time for which a problem is reported after the last check that found it, milliseconds. [EX-18] */
const STANDS_MS = 30_000;

/** Findings of one check. */
export type FoundProblem = Omit<Problem, 'sinceMs'>;

interface Finding {
  problem: FoundProblem;
  /** Looks in a row that found it. */
  looks: number;
  /** Since it is a problem, epoch milliseconds; undefined while it is none. */
  sinceMs: number | undefined;
  /** When it was found last, monotonic milliseconds. */
  lastMs: number;
}

/** Turns repeated findings into problems: from the second look on, and for some time after the last. */
export class Findings {
  readonly #clock: Clock;
  readonly #events: EventLog;
  readonly #findings = new Map<string, Finding>();

  constructor(clock: Clock, events: EventLog) {
    this.#clock = clock;
    this.#events = events;
  }

  /** Takes all that a look found, by what it is about. */
  take(found: ReadonlyMap<string, FoundProblem>): void {
    const lastMs = this.#clock.monotonicMs();
    for (const [key, problem] of found) {
      const finding = this.#findings.get(key);
      const looks = (finding?.looks ?? 0) + 1;
      const next = { problem, looks, lastMs, sinceMs: finding?.sinceMs };
      this.#findings.set(key, next);
      if (looks < LOOKS_BEFORE || next.sinceMs !== undefined) continue;
      next.sinceMs = this.#clock.nowMs();
      this.#events.add(StatusEventKind.OVERLOAD, problem.text, problem.clientId);
    }
    for (const [key, finding] of this.#findings) {
      if (found.has(key)) continue;
      finding.looks = 0;
      const isOver = finding.sinceMs === undefined || lastMs - finding.lastMs > STANDS_MS;
      if (isOver) this.#findings.delete(key);
    }
  }

  /** Whether the latest look, and enough before it, found this. */
  isNow(key: string): boolean {
    return (this.#findings.get(key)?.looks ?? 0) >= LOOKS_BEFORE;
  }

  problems(): Problem[] {
    return [...this.#findings.values()].flatMap(({ problem, sinceMs }) =>
      sinceMs === undefined ? [] : [{ ...problem, sinceMs }],
    );
  }
}
