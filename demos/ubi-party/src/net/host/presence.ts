import type { Clock, UbiiClient } from '@ubii/client-web';
import type { PhoneDelay } from '../../modules/index.ts';
import type { Room, RoomEvent, Seat } from '../../sim/index.ts';
import { phoneOf } from '../protocol.ts';
import { DelayWatch } from './phone-delays.ts';

/** A phone without a message for this long is away, milliseconds; phones send one each second. */
export const AWAY_AFTER_MS = 3000;
const FORGET_AFTER_MS = 10 * 60_000;
/** More phones than can play. */
const MAX_PHONES = 128;

export interface PresenceOptions {
  readonly client: UbiiClient;
  readonly clock: Clock;
  readonly nowMs: () => number;
  readonly room: () => Room;
  readonly apply: (event: RoomEvent) => void;
}

/** Which phones are present: time of the last message, round trip and delay of each. */
export class Presence {
  readonly #options: PresenceOptions;
  readonly #seen = new Map<string, { readonly atMs: number; readonly lagMs: number }>();

  readonly #delays: DelayWatch;

  constructor(options: PresenceOptions) {
    this.#options = options;
    const { client, clock, room } = options;
    const keys = (): string[] => room().players.flatMap(({ key }) => key ?? []);
    this.#delays = new DelayWatch({ client, clock, keys });
  }

  /** Bounds of the delay of a phone; undefined without a measurement. */
  delayOf(key: string): PhoneDelay | undefined {
    return this.#delays.delays.of(key);
  }

  /** @returns when messages arrive, and what ends it */
  open(): { readonly ready: Promise<void>; close(): void } {
    const here = this.#options.client.subscribe({ glob: '/*/party/here' }, { format: 'double' });
    here.onRecord(({ topic, value }) => {
      const key = phoneOf(topic, 'here');
      if (key !== undefined) this.#handleHere(key, value);
    });
    const stopDelays = this.#delays.start();
    return {
      ready: here.ready,
      close: () => {
        stopDelays();
        void here.close();
      },
    };
  }

  /** A request is a message as well; a phone that leaves is absent at once. */
  handleRequest(key: string, { type }: RoomEvent): void {
    if (type === 'leave' || type === 'away') this.#seen.delete(key);
    else if (this.#personOf(key)) this.#record(key, 0);
  }

  /** Marks silent phones as away. */
  update(): void {
    const nowMs = this.#options.nowMs();
    for (const { key, awaySinceMs } of this.#people()) {
      if (key === undefined || awaySinceMs !== undefined) continue;
      if (!this.#isHere(key, nowMs)) this.#options.apply({ type: 'away', key });
    }
    for (const [key, { atMs }] of this.#seen) {
      if (nowMs - atMs > FORGET_AFTER_MS) this.#seen.delete(key);
    }
  }

  /** Round trips of the present phones, by seat, whole milliseconds. Without a measurement, the value that the phone states. */
  lags(): Record<Seat, number> {
    const nowMs = this.#options.nowMs();
    const lags: Record<Seat, number> = {};
    for (const { seat, key } of this.#options.room().players) {
      if (key !== undefined && this.#isHere(key, nowMs))
        lags[seat] = Math.round(this.#delays.delays.lagOf(key) ?? this.#seen.get(key)!.lagMs);
    }
    return lags;
  }

  /** Clients without a place are not remembered: there may be any number. */
  #handleHere(key: string, lagMs: number): void {
    const person = this.#personOf(key);
    if (!person) return;
    this.#record(key, lagMs);
    if (person.awaySinceMs !== undefined) this.#options.apply({ type: 'back', key });
  }

  /** @param lagMs stated by the phone; not checked yet */
  #record(key: string, lagMs: number): void {
    if (!this.#seen.has(key) && this.#seen.size >= MAX_PHONES) return;
    const isLag = Number.isFinite(lagMs) && lagMs >= 0;
    this.#seen.set(key, {
      atMs: this.#options.nowMs(),
      lagMs: isLag ? Math.min(lagMs, 60_000) : 0,
    });
  }

  #isHere(key: string, nowMs: number): boolean {
    const seen = this.#seen.get(key);
    return seen !== undefined && nowMs - seen.atMs < AWAY_AFTER_MS;
  }

  #personOf(key: string): { readonly awaySinceMs?: number } | undefined {
    return this.#people().find((person) => person.key === key);
  }

  /** Players, bots and spectators. */
  #people(): readonly { readonly key?: string; readonly awaySinceMs?: number }[] {
    const { players, spectators } = this.#options.room();
    return [...players, ...spectators];
  }
}
