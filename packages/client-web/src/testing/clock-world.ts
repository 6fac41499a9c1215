import type { Cancel, Clock } from '@ubii/timing';
import { Link } from '../core/connection/link.ts';
import type { TopicDataHandler, TopicDataTransport } from '../core/ports/topic-data-transport.ts';
import { MasterClock } from '../core/time/master-clock.ts';

/** Latency of one direction, milliseconds. @param random from 0 to below 1 */
export type WayMs = (random: () => number) => number;

/** Properties of clocks and network. */
export interface ClockWorldOptions {
  readonly seed: number;
  /** Parts per million that the client's timer is too fast. */
  readonly driftPpm?: number;
  /** Steps of the client's clocks, milliseconds. */
  readonly grainMs?: number;
  readonly toMasterMs: WayMs;
  readonly toClientMs: WayMs;
}

interface Event {
  atMs: number;
  /** Waits while the client sleeps. */
  readonly isOfClient: boolean;
  readonly fn: () => void;
}

const EPOCH_MS = 1_767_225_600_000;

/**
 * A client and its master with clocks of their own and a network between them, in simulated time:
 * here the truth is known. The client's timer stands still while it sleeps; its wall clock goes on.
 */
export class ClockWorld {
  readonly masterClock: MasterClock;
  readonly random: () => number;
  readonly #options: ClockWorldOptions;
  readonly #clock: Clock;
  /** Sorted by time. */
  #events: Event[] = [];
  #trueMs = 0;
  #timerMs = 1_000;
  #wallAheadMs: number;
  #masterAheadMs = 0;
  #masterRate = 1;
  #isAsleep = false;
  #link: Link | undefined;
  /** TCP keeps the order. */
  readonly #lastArrivalMs = { toMaster: 0, toClient: 0 };

  constructor(options: ClockWorldOptions) {
    this.#options = options;
    this.random = randomOf(options.seed);
    this.#wallAheadMs = (this.random() - 0.5) * 60_000;
    this.#clock = {
      nowMs: () => Math.floor(EPOCH_MS + this.#timerMs + this.#wallAheadMs),
      monotonicMs: () => this.#inGrains(this.#timerMs),
      after: (delayMs, fn) => this.#after(delayMs, fn),
      every: (intervalMs, fn) => this.#every(intervalMs, fn),
      atEndOfTurn: (fn) => void this.#at(this.#trueMs, true, fn),
    };
    this.masterClock = new MasterClock(
      this.#clock,
      () => this.#link?.measureTime(),
      (error) => void Promise.reject(error),
    );
  }

  /** Current time of the master's clock. */
  get masterMs(): number {
    return EPOCH_MS + this.#trueMs + this.#masterAheadMs;
  }

  /** Opens a link, in place of the one before: its master may be another one. */
  connect(): void {
    this.#link?.close();
    this.masterClock.handleLink();
    this.#link = new Link({
      transport: this.#transport(),
      query: { clientId: 'ada', resumeToken: undefined },
      clock: this.#clock,
      canPing: true,
      openTimeoutMs: 30_000,
      handleBinary: () => undefined,
      handleUnknownText: () => undefined,
      handleRoundTrip: () => undefined,
      time: {
        handleExchange: (exchange) => this.masterClock.handleExchange(exchange),
        describeClock: () => '',
      },
      handleEnd: () => this.#after(500, () => this.connect()),
    });
  }

  /** Lets true time pass. */
  pass(durationMs: number): void {
    const endMs = this.#trueMs + durationMs;
    for (;;) {
      const next = this.#events.find(({ isOfClient }) => !(isOfClient && this.#isAsleep));
      if (next === undefined || next.atMs > endMs) break;
      this.#events.splice(this.#events.indexOf(next), 1);
      this.#moveTo(Math.max(this.#trueMs, next.atMs));
      next.fn();
    }
    this.#moveTo(endMs);
  }

  sleep(durationMs: number): void {
    this.#isAsleep = true;
    const beforeMs = this.#trueMs;
    this.pass(durationMs);
    this.#isAsleep = false;
    // Timers count the time that the timer's clock counts.
    for (const event of this.#events) if (event.isOfClient) event.atMs += this.#trueMs - beforeMs;
  }

  /** Sets the client's clock, as a user or NTP would. */
  setWall(byMs: number): void {
    this.#wallAheadMs += byMs;
  }

  /** Sets the master's clock, as a user or NTP would. */
  setMaster(byMs: number): void {
    this.#masterAheadMs += byMs;
  }

  /** The master's system corrects its clock slowly. @param ppm 0 ends it */
  slewMaster(ppm: number): void {
    this.#masterRate = 1 + ppm * 1e-6;
  }

  #moveTo(trueMs: number): void {
    const passedMs = trueMs - this.#trueMs;
    this.#trueMs = trueMs;
    this.#masterAheadMs += passedMs * (this.#masterRate - 1);
    if (this.#isAsleep) this.#wallAheadMs += passedMs;
    else this.#timerMs += passedMs * (1 + (this.#options.driftPpm ?? 0) * 1e-6);
  }

  #inGrains(ms: number): number {
    const { grainMs = 0.005 } = this.#options;
    return Math.floor(ms / grainMs) * grainMs;
  }

  #transport(): TopicDataTransport {
    return {
      open: (_query, handler) => {
        this.#send('toClient', () => handler.handleOpen());
        return {
          sendBinary: () => undefined,
          sendText: (text) => this.#send('toMaster', () => this.#answer(text, handler)),
          bufferedBytes: 0,
          close: () => undefined,
        };
      },
    };
  }

  #answer(text: string, handler: TopicDataHandler): void {
    const receivedMs = this.masterMs;
    const [, number] = text.split(' ');
    const busyMs = this.random() ** 8 * 5;
    this.#at(this.#trueMs + busyMs, false, () => {
      const pong = `PONG ${number} ${receivedMs.toFixed(3)} ${this.masterMs.toFixed(3)}`;
      this.#send('toClient', () => handler.handleText(pong));
    });
  }

  #send(way: 'toMaster' | 'toClient', fn: () => void): void {
    const wayMs = way === 'toMaster' ? this.#options.toMasterMs : this.#options.toClientMs;
    const atMs = Math.max(this.#lastArrivalMs[way], this.#trueMs + wayMs(this.random));
    this.#lastArrivalMs[way] = atMs;
    this.#at(atMs, way === 'toClient', fn);
  }

  #after(delayMs: number, fn: () => void): Cancel {
    const rate = 1 + (this.#options.driftPpm ?? 0) * 1e-6;
    return this.#at(this.#trueMs + delayMs / rate, true, fn);
  }

  #every(intervalMs: number, fn: () => void): Cancel {
    let cancel = this.#after(intervalMs, again.bind(this));
    function again(this: ClockWorld): void {
      cancel = this.#after(intervalMs, again.bind(this));
      fn();
    }
    return () => cancel();
  }

  #at(atMs: number, isOfClient: boolean, fn: () => void): Cancel {
    const event: Event = { atMs, isOfClient, fn };
    const place = this.#events.findLastIndex((other) => other.atMs <= atMs) + 1;
    this.#events.splice(place, 0, event);
    return () => {
      this.#events = this.#events.filter((other) => other !== event);
    };
  }
}

/** Numbers from 0 to below 1, the same for the same seed (mulberry32). */
export function randomOf(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}
