import type { UbiiClient } from '@ubii/client-web';
import type { RoundState } from '../../modules/index.ts';
import { cheerOf, type Cheer, type GameId, type Room } from '../../sim/index.ts';
import { isWatched, liveRoundOf } from '../live-round.ts';
import { LIVE_TOPIC, PHONE_DEVICE, phoneOf } from '../topics.ts';
import { RequestLimit } from './request-limit.ts';

/** Phones are told the round so often, steps. */
const LIVE_STEPS = 30;
/** Of each phone: a few quick ones, then one a second. */
const OWN_LIMIT = { atOnce: 3, perSecond: 1 };
/** Of all together: more could not be distinguished on the big screen. */
const COMMON_LIMIT = { atOnce: 16, perSecond: 8 };

export interface AudienceOptions {
  readonly client: UbiiClient;
  readonly nowMs: () => number;
  readonly room: () => Room;
  readonly handleCheer: (cheer: Cheer) => void;
}

/** Those who do not play now: shows them the round, and takes their cheers at a bounded rate. */
export class Audience {
  readonly #options: AudienceOptions;
  readonly #own = new RequestLimit(OWN_LIMIT);
  readonly #common = new RequestLimit(COMMON_LIMIT);
  #dropped = 0;
  /** The step of the round that was told last; undefined: it is not known. */
  #toldStep: number | 'nothing' | undefined;

  constructor(options: AudienceOptions) {
    this.#options = options;
  }

  /** Number of cheers dropped by the rate limit. */
  get dropped(): number {
    return this.#dropped;
  }

  /** @returns when cheers are heard, and what ends it */
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
    const told = typeof this.#toldStep === 'number' ? this.#toldStep : -Infinity;
    const passed = Math.abs(state.step - told);
    if (passed < LIVE_STEPS && !state.isOver) return;
    const room = this.#options.room();
    if (!isWatched(room)) return this.clear();
    const live = liveRoundOf(game, state, room);
    if (!live) return;
    this.#toldStep = state.step;
    this.#options.client.publish(LIVE_TOPIC, 'string', JSON.stringify(live));
  }

  /** Ends the topic: there is no round, or it has no spectators. */
  clear(): void {
    // Also what an earlier screen told
    if (this.#toldStep !== 'nothing') this.#options.client.endTopic(LIVE_TOPIC);
    this.#toldStep = 'nothing';
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
