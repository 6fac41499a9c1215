import { ServiceError } from '@ubii/proto';
import { TokenBucket, type Clock } from '@ubii/timing';
import type { LimitWatch } from '../counters/limit-watch.ts';
import { quote } from '../texts/quote.ts';
import type { Session } from './session.ts';

/** Seconds of the long run that may be used at once. */
const BURST_SECONDS = 32;
/** Invitations that are remembered; those of the longest ago are forgotten first. */
const MOST = 1_024;

/**
 * Limits the rate at which callers of each invitation start sessions, which are announced with their full content.
 * [EX-77]
 */
export class StartPace {
  readonly #clock: Clock;
  readonly #limits: LimitWatch;
  readonly #buckets = new Map<string, TokenBucket>();

  constructor(clock: Clock, limits: LimitWatch) {
    this.#clock = clock;
    this.#limits = limits;
  }

  /**
   * Counts a start.
   * @param maker Grant of who starts it; empty for who needs none.
   * @throws ServiceError when it comes too soon
   */
  spend(session: Session, maker: string): void {
    const nowMs = this.#clock.monotonicMs();
    const bucket = this.#bucketOf(maker, nowMs);
    const waitMs = bucket.waitMs(nowMs);
    if (waitMs === 0) {
      bucket.spend(session.byteLength, nowMs);
      return;
    }
    this.#limits.count('sessionStartBytesPerSecond');
    const { sessionStartBytesPerSecond: max } = this.#limits.limits;
    throw new ServiceError(
      'resource_exhausted',
      `A starting session is sent to all subscribers, and the sessions started recently were too large to start ${quote(session.label)} now (limit sessionStartBytesPerSecond). Try again in ${Math.ceil(waitMs / 1000)} s.`,
      { details: { limit: 'sessionStartBytesPerSecond', max } },
    );
  }

  #bucketOf(maker: string, nowMs: number): TokenBucket {
    const known = this.#buckets.get(maker);
    if (known !== undefined) return known;
    const { sessionStartBytesPerSecond: perSecond } = this.#limits.limits;
    const bucket = new TokenBucket(perSecond, nowMs, BURST_SECONDS * perSecond);
    this.#buckets.set(maker, bucket);
    const [oldest] = this.#buckets.keys();
    if (this.#buckets.size > MOST && oldest !== undefined) this.#buckets.delete(oldest);
    return bucket;
  }
}
