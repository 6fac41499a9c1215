import type { UbiiClient } from '@ubii/client-web';
import type { RoundState } from '../../modules/index.ts';
import { cheerOf, type Cheer, type GameId, type Room } from '../../sim/index.ts';
import { isWatched, liveRoundOf } from '../live-round.ts';
import { LIVE_TOPIC, PHONE_DEVICE, phoneOf } from '../protocol.ts';
import { RequestLimit } from './request-limit.ts';

/** Steps between two records of the round in words. */
const LIVE_STEPS = 30;
/** For each phone: a burst, then one a second. */
const OWN_LIMIT = { atOnce: 3, perSecond: 1 };
/** For all phones together: more could not be distinguished on the big screen. */
const COMMON_LIMIT = { atOnce: 16, perSecond: 8 };

export interface AudienceOptions {
  readonly client: UbiiClient;
  readonly nowMs: () => number;
  readonly room: () => Room;
  readonly handleCheer: (cheer: Cheer) => void;
}

/** Publishes the round for clients that do not play now, and receives their cheers at a limited rate. */
export class Audience {
  readonly #options: AudienceOptions;
  readonly #own = new RequestLimit(OWN_LIMIT);
  readonly #common = new RequestLimit(COMMON_LIMIT);
  #dropped = 0;
  /** Step of the newest record; undefined: not known. */
  #publishedStep: number | 'nothing' | undefined;

  constructor(options: AudienceOptions) {
    this.#options = options;
  }

  /** Number of cheers dropped by the rate limit. */
  get dropped(): number {
    return this.#dropped;
  }

  /** @returns when cheers arrive, and what ends it */
  open(): { readonly ready: Promise<void>; close(): void } {
    const glob = `/*/${PHONE_DEVICE}/cheer`;
    const cheers = this.#options.client.subscribe({ glob }, { format: 'string' });
    cheers.onRecord(({ topic, value }) => {
      const key = phoneOf(topic, 'cheer');
      if (key !== undefined) this.#handleCheer(key, value);
    });
    return { ready: cheers.ready, close: () => void cheers.close() };
  }

  /** Publishes the round in words twice a second, while the room has spectators. */
  handleState(game: GameId, state: RoundState): void {
    const published = typeof this.#publishedStep === 'number' ? this.#publishedStep : -Infinity;
    const passed = Math.abs(state.step - published);
    if (passed < LIVE_STEPS && !state.isOver) return;
    const room = this.#options.room();
    if (!isWatched(room)) return this.clear();
    const live = liveRoundOf(game, state, room);
    if (!live) return;
    this.#publishedStep = state.step;
    this.#options.client.publish(LIVE_TOPIC, 'string', JSON.stringify(live));
  }

  /** Ends the topic: there is no round, or it has no spectators. */
  clear(): void {
    // Also the record of an earlier screen
    if (this.#publishedStep !== 'nothing') this.#options.client.endTopic(LIVE_TOPIC);
    this.#publishedStep = 'nothing';
  }

  #handleCheer(key: string, kind: string): void {
    const cheer = cheerOf(this.#options.room(), key, kind);
    if (!cheer) return;
    const nowMs = this.#options.nowMs();
    if (this.#own.isAllowed(key, nowMs) && this.#common.isAllowed('all', nowMs))
      this.#options.handleCheer(cheer);
    else this.#dropped += 1;
  }
}
