import { ServiceError, StatusEventKind } from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import type { LimitName, Limits } from '../limits/index.ts';
import type { Log } from '../ports/log.ts';
import type { EventLog } from './event-log.ts';
import { Streak } from './streak.ts';

/** Number of times that a limit was reached. */
export interface LimitHits {
  readonly limit: LimitName;
  readonly streak: Streak;
  /** Client that reached it last, if it was a registered client. */
  clientId: string | undefined;
}

/** Counts hits of limits, and logs each series of hits once. */
export class LimitWatch {
  readonly limits: Limits;
  readonly #clock: Clock;
  readonly #log: Log;
  readonly #events: EventLog;
  readonly #hits = new Map<LimitName, LimitHits>();

  constructor(limits: Limits, clock: Clock, log: Log, events: EventLog) {
    this.limits = limits;
    this.#clock = clock;
    this.#log = log;
    this.#events = events;
  }

  hits(): Iterable<LimitHits> {
    return this.#hits.values();
  }

  /** Counts a hit. */
  count(limit: LimitName, clientId?: string): void {
    let hits = this.#hits.get(limit);
    if (hits === undefined) {
      hits = { limit, streak: new Streak(), clientId };
      this.#hits.set(limit, hits);
    }
    hits.clientId = clientId;
    if (!hits.streak.add(this.#clock.monotonicMs())) return;
    const text = `The limit ${limit} (${this.limits[limit]}) was reached`;
    this.#log.warn(text, { limit, clientId });
    this.#events.add(StatusEventKind.LIMIT_REACHED, text, clientId);
  }

  /**
   * Counts a hit and gives the error for it.
   * @param text What there would be too many of, with the number: `more than 10 cats`.
   */
  refusal(limit: LimitName, text: string, clientId?: string): ServiceError {
    this.count(limit, clientId);
    return new ServiceError(
      'resource_exhausted',
      `This would be ${text}, which is the limit ${limit} of this master; remove what is not needed, or raise the limit with --limits ${limit}=<number>.`,
      { details: { limit, max: this.limits[limit] } },
    );
  }
}
