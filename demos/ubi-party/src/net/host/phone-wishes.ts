import type { UbiiClient } from '@ubii/client-web';
import { RoomRefusal, type RoomEvent } from '../../sim/index.ts';
import type { HostReply, PhoneRequest, PhoneWish } from '../messages.ts';
import { phoneOf, phoneTopic } from '../topics.ts';
import { parseRequest } from './parse-request.ts';
import { RequestLimit } from './request-limit.ts';
import { SeatOffers } from './seat-offers.ts';

export interface PhoneWishesOptions {
  readonly client: UbiiClient;
  readonly nowMs: () => number;
  /** A random integer from 0 to 255. */
  readonly drawByte: () => number;
  hasSeat(key: string): boolean;
  /** @throws RoomRefusal with the sentence for who asked */
  decide(key: string, event: RoomEvent): void;
  /** Evicts one client of a crowded address for a client that was refused a place. @returns whether it did. Never rejects */
  makeRoom(key: string, as: 'join' | 'watch'): Promise<boolean>;
}

/** Receives requests of phones, each at a limited rate, and sends the answers. */
export class PhoneWishes {
  readonly #options: PhoneWishesOptions;
  readonly #offers: SeatOffers;
  readonly #limit = new RequestLimit();

  constructor(options: PhoneWishesOptions) {
    this.#options = options;
    this.#offers = new SeatOffers(options.drawByte);
  }

  /** @returns when phones are heard, and what ends it */
  open(): { readonly ready: Promise<void>; close(): void } {
    const requests = this.#options.client.subscribe(
      { glob: '/*/party/request' },
      { format: 'string' },
    );
    requests.onRecord(({ topic, value }) => {
      const key = phoneOf(topic, 'request');
      if (key !== undefined) this.#handleRequest(key, value);
    });
    return { ready: requests.ready, close: () => void requests.close() };
  }

  /** A code with which another phone takes over the seat of a client. */
  offer(key: string): string {
    return this.#offers.offer(key, this.#options.nowMs());
  }

  #handleRequest(key: string, text: string): void {
    if (!this.#limit.isAllowed(key, this.#options.nowMs())) return;
    const request = parseRequest(text);
    if (!request) return;
    const reply = this.#answer(key, request);
    const { type } = request.wish;
    if ('refusal' in reply && (type === 'join' || type === 'watch')) {
      void this.#options.makeRoom(key, type).then((isMade) => {
        this.#reply(key, isMade ? this.#answer(key, request) : reply);
      });
    } else this.#reply(key, reply);
  }

  #reply(key: string, reply: HostReply): void {
    const text = JSON.stringify(reply);
    this.#options.client.publish(phoneTopic(key, 'reply'), 'string', text, { immediate: true });
  }

  #answer(key: string, { number, wish }: PhoneRequest): HostReply {
    try {
      if (wish.type === 'offer') return { number, code: this.#offerOwn(key) };
      this.#options.decide(key, this.#eventOf(key, wish));
      return { number };
    } catch (cause) {
      if (!(cause instanceof RoomRefusal)) throw cause;
      return { number, refusal: cause.message };
    }
  }

  #offerOwn(key: string): string {
    if (!this.#options.hasSeat(key)) throw new RoomRefusal('This phone has no seat.');
    return this.offer(key);
  }

  #eventOf(key: string, wish: Exclude<PhoneWish, { type: 'offer' }>): RoomEvent {
    switch (wish.type) {
      case 'take': {
        const owner = this.#offers.take(wish.code, this.#options.nowMs());
        if (owner === undefined)
          throw new RoomRefusal('This code is not valid any more. Ask for a new one.');
        return { type: 'hand-over', key: owner, to: key };
      }
      case 'join':
      case 'watch':
      case 'leave':
      case 'away':
      case 'back':
      case 'ready':
        return { ...wish, key };
      default:
        return { ...wish, by: { key } };
    }
  }
}
