import type { UbiiClient } from '@ubii/client-web';

import { isPace, RoomRefusal, type RoomEvent, type Room } from '../../sim/index.ts';
import {
  phoneOf,
  phoneTopic,
  type PhoneRequest,
  type PhoneAction,
  type HostReply,
} from '../protocol.ts';
import { Crowding } from './crowding.ts';
import { RequestLimit } from './request-limit.ts';

const MAX_CHARACTERS = 1000;

/** Parses a request of a phone; undefined if invalid: any client that has joined may publish any text. */
function parseRequest(text: string): PhoneRequest | undefined {
  if (text.length > MAX_CHARACTERS) return undefined;
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    return undefined;
  }
  if (!isObject(value) || !Number.isSafeInteger(value['number'])) return undefined;
  const wish = parseAction(value['wish']);
  return wish && { number: value['number'] as number, wish };
}

function parseAction(value: unknown): PhoneAction | undefined {
  if (!isObject(value)) return undefined;
  const check = CHECKS[value['type'] as PhoneAction['type']];
  // Object.hasOwn: `constructor` is not an action
  if (!Object.hasOwn(CHECKS, String(value['type'])) || !check(value)) return undefined;
  return value as unknown as PhoneAction;
}

type Check = (action: Record<string, unknown>) => boolean;
const text =
  (member: string): Check =>
  (action) =>
    typeof action[member] === 'string';
const flag =
  (member: string): Check =>
  (action) =>
    typeof action[member] === 'boolean';
const whole =
  (member: string): Check =>
  (action) =>
    Number.isSafeInteger(action[member]);
const nothing: Check = () => true;

const CHECKS: Record<PhoneAction['type'], Check> = {
  join: text('name'),
  watch: text('name'),
  leave: nothing,
  away: nothing,
  back: nothing,
  ready: flag('isReady'),
  offer: nothing,
  take: text('code'),
  proceed: nothing,
  kick: whole('seat'),
  lead: whole('seat'),
  dismiss: text('key'),
  lock: flag('on'),
  'hide-code': flag('on'),
  'set-teams': whole('teams'),
  'set-pace': ({ pace }) => isPace(pace),
  'set-games': ({ games }) =>
    Array.isArray(games) && games.length <= 12 && games.every((game) => typeof game === 'string'),
  fill: whole('players'),
};

const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

/** Letters and digits that are not confused with each other. */
const LETTERS = 'ABCDEFGHJKLMNPRSTUVWXYZ23456789';
const CODE_LENGTH = 6;
const LASTS_MS = 2 * 60_000;

/** Codes with which another phone takes over a seat: each once, for two minutes, one a seat. */
export class SeatOffers {
  readonly #byCode = new Map<string, { readonly key: string; readonly untilMs: number }>();
  readonly #drawByte: () => number;

  /** @param drawByte a random integer from 0 to 255 */
  constructor(drawByte: () => number) {
    this.#drawByte = drawByte;
  }

  /** A new code for the seat of a client; its earlier code is not valid any more. */
  offer(key: string, nowMs: number): string {
    for (const [code, { key: other, untilMs }] of this.#byCode) {
      if (other === key || untilMs <= nowMs) this.#byCode.delete(code);
    }
    const code = Array.from({ length: CODE_LENGTH }, () => this.#drawLetter()).join('');
    this.#byCode.set(code, { key, untilMs: nowMs + LASTS_MS });
    return code;
  }

  /** The client whose seat a code is for. The code is used up. */
  take(code: string, nowMs: number): string | undefined {
    const wanted = code.toUpperCase().replace(/[^A-Z0-9]/g, '');
    const offer = this.#byCode.get(wanted);
    this.#byCode.delete(wanted);
    return offer && offer.untilMs > nowMs ? offer.key : undefined;
  }

  /** Each letter is as likely as the others: bytes beyond the last whole alphabet are drawn again. */
  #drawLetter(): string {
    for (;;) {
      const byte = this.#drawByte();
      if (byte < 256 - (256 % LETTERS.length)) return LETTERS[byte % LETTERS.length]!;
    }
  }
}

interface PhoneRequestsOptions {
  readonly client: UbiiClient;
  readonly nowMs: () => number;
  /** A random integer from 0 to 255. */
  readonly drawByte: () => number;
  readonly room: () => Room;
  /** @throws RoomRefusal with a sentence for the player */
  readonly decide: (key: string, event: RoomEvent) => void;
}

/** Receives requests of phones, each at a limited rate, and sends the answers. */
export class PhoneRequests {
  readonly #options: PhoneRequestsOptions;
  readonly #offers: SeatOffers;
  readonly #crowding: Crowding;
  readonly #limit = new RequestLimit();

  constructor(options: PhoneRequestsOptions) {
    this.#options = options;
    this.#offers = new SeatOffers(options.drawByte);
    const { client, room, decide } = options;
    this.#crowding = new Crowding({
      client,
      room,
      remove: (key) => decide(key, { type: 'leave', key }),
    });
  }

  /** @returns when requests arrive, and what ends it */
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
      void this.#crowding.makeRoom(key, type).then((isMade) => {
        this.#reply(key, isMade ? this.#answer(key, request) : reply);
      });
    } else this.#reply(key, reply);
  }

  #reply(key: string, reply: HostReply): void {
    const text = JSON.stringify(reply);
    this.#options.client.publish(phoneTopic(key, 'reply'), 'string', text, { immediate: true });
  }

  #answer(key: string, { number, wish: action }: PhoneRequest): HostReply {
    try {
      if (action.type === 'offer') return { number, code: this.#offerOwn(key) };
      this.#options.decide(key, this.#eventOf(key, action));
      return { number };
    } catch (cause) {
      if (!(cause instanceof RoomRefusal)) throw cause;
      return { number, refusal: cause.message };
    }
  }

  #offerOwn(key: string): string {
    const { players } = this.#options.room();
    if (!players.some((player) => player.key === key))
      throw new RoomRefusal('This phone has no seat.');
    return this.offer(key);
  }

  #eventOf(key: string, action: Exclude<PhoneAction, { type: 'offer' }>): RoomEvent {
    switch (action.type) {
      case 'take': {
        const owner = this.#offers.take(action.code, this.#options.nowMs());
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
        return { ...action, key };
      default:
        return { ...action, by: { key } };
    }
  }
}
