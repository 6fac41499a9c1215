import type { Cancel, Clock } from '@ubii/timing';
import { ConnectionError } from './connection-error.ts';
import { Deferred } from '../callbacks/deferred.ts';
import { BROKEN, failureOfClose } from './link-failure.ts';
import type { LinkFailure } from './link-failure.ts';
import type {
  TopicDataQuery,
  TopicDataSocket,
  TopicDataTransport,
} from '../ports/topic-data-transport.ts';
import { Probe } from './probe.ts';
import { readClocks } from '../time/clock-reading.ts';
import { atDeadline } from '../time/deadline.ts';
import type { ClockReading } from '../time/clock-reading.ts';
import type { TimeExchange } from '../time/time-sample.ts';

/** Interval of PING messages to the master, milliseconds. [EX-6] */
export const PING_INTERVAL_MS = 2_000;
/**
 * A socket on which nothing arrived for this many PINGs in a row is dead, though it looks open: the
 * other machine lost power, or the network changed under us. Counted in PINGs and not in time, so
 * that a page whose timers slept does not drop a good link when it wakes.
 */
const SILENT_PINGS = 3;
/** The clock is measured with so many PINGs more, so far apart in milliseconds. [TS-3] */
const BURST_PINGS = 7;
const BURST_INTERVAL_MS = 50;
/** A PONG that tells the master's time. [TS-2] */
const TIMED_PONG = /^PONG (\d{1,10}) (\d{1,15}(?:\.\d{1,6})?) (\d{1,15}(?:\.\d{1,6})?)$/;

/** Dependencies of a link. */
export interface LinkOptions {
  readonly transport: TopicDataTransport;
  readonly query: TopicDataQuery;
  readonly clock: Clock;
  /** Whether the master answers PING: masters of ours do. */
  readonly canPing: boolean;
  /** Timeout for opening and for the first reply, milliseconds. */
  readonly openTimeoutMs: number;
  /** The bytes are the callee's to keep. */
  readonly handleBinary: (bytes: Uint8Array) => void;
  /** A text frame other than PING and PONG. */
  readonly handleUnknownText: (text: string) => void;
  readonly handleRoundTrip: (roundTripMs: number) => void;
  /** Measurement of the master's clock; undefined for masters that do not report their time. */
  readonly time: LinkTime | undefined;
  /** Called once, unless `close()` was called before. */
  readonly handleEnd: (failure: LinkFailure) => void;
}

/** Clock exchange of a link. [TS-2] */
export interface LinkTime {
  handleExchange(exchange: TimeExchange): void;
  /** Returns the clock sample that the next PING sends to the master; empty without one. [TS-10] */
  describeClock(): string;
}

/** A PING that waits for its PONG. */
interface SentPing {
  readonly number: number;
  readonly sent: ClockReading;
  /** Sent for the clock alone: neither activity nor a round trip is expected of it. */
  readonly isExtra: boolean;
  /** Settled by the PONG; undefined when no caller waits for it. */
  readonly answered: Deferred<void> | undefined;
}

/**
 * One socket from opening to its end. A master of ours may accept a socket only to close it with the
 * code that says why, so there a link counts as up when the first PONG has come.
 */
export class Link {
  /** Resolves when the link is up, rejects with the `LinkFailure` when it ends before. */
  readonly up: Promise<void>;

  readonly #options: LinkOptions;
  readonly #socket: TopicDataSocket;
  readonly #up = new Deferred<void>();
  readonly #cancelOpenTimer: Cancel;
  #cancelPings: Cancel | undefined;
  readonly #probe: Probe;
  /** Of the last measurement, milliseconds. */
  #tripMs: number | undefined;
  #isUp = false;
  #failure: LinkFailure | undefined;
  #cancelBurst: Cancel | undefined;
  /** Oldest first. */
  #pings: SentPing[] = [];
  #pingNumber = 0;
  #silentPings = 0;

  constructor(options: LinkOptions) {
    this.#options = options;
    this.up = this.#up.promise;
    this.#probe = new Probe({
      clock: options.clock,
      ask: (answered) => this.#ping({ answered }),
      usualTripMs: () => this.#tripMs,
      handleDead: (waitedMs) => this.#endSilent(`${Math.round(waitedMs)} ms`),
    });
    this.#cancelOpenTimer = atDeadline(options.clock, options.openTimeoutMs, () =>
      this.#endWithTimeout(
        `Expected the topic-data socket to open and answer within ${options.openTimeoutMs} ms`,
      ),
    );
    this.#socket = options.transport.open(options.query, {
      handleOpen: () => this.#handleOpen(),
      handleBinary: (bytes) => this.#handleBinary(bytes),
      handleText: (text) => this.#handleText(text),
      handleClose: (code, reason) => this.#end(failureOfClose(code, reason, this.#isUp)),
    });
  }

  get isUp(): boolean {
    return this.#isUp && this.#failure === undefined;
  }

  /** Bytes handed over and not yet taken by the system. */
  get bufferedBytes(): number {
    return this.#socket.bufferedBytes;
  }

  sendBinary(borrowedBytes: Uint8Array): void {
    this.#socket.sendBinary(borrowedBytes);
  }

  /** Ends the link as failed when the master does not answer soon. [CL-42] */
  probe(): void {
    if (this.isUp && this.#options.canPing) this.#probe.start();
  }

  /** Resolves when the master has handled all that was sent so far, or the link ended; at once where it cannot be asked. */
  async handled(): Promise<void> {
    if (!this.isUp || !this.#options.canPing) return;
    const answered = new Deferred<void>();
    this.#ping({ answered });
    await answered.promise;
  }

  /** Measures the master's clock with some PINGs at once, unless that is being done. [TS-3] */
  measureTime(): void {
    if (!this.isUp || this.#options.time === undefined || this.#cancelBurst !== undefined) return;
    let left = BURST_PINGS;
    this.#cancelBurst = this.#options.clock.every(BURST_INTERVAL_MS, () => {
      this.#ping({ isExtra: true });
      left -= 1;
      if (left > 0) return;
      this.#cancelBurst?.();
      this.#cancelBurst = undefined;
    });
  }

  /** Closes the socket without `handleEnd`; idempotent. */
  close(code = 1000, reason = ''): void {
    if (this.#failure !== undefined) return;
    this.#finish({
      error: new ConnectionError('closed', 'The connection was closed'),
      code: BROKEN, // a code in a failure is the master's word
      wasUp: this.#isUp,
    });
    this.#socket.close(code, reason);
  }

  #handleOpen(): void {
    if (this.#failure !== undefined) return;
    if (this.#options.canPing) this.#ping();
    else this.#handleUp();
  }

  #handleUp(): void {
    this.#isUp = true;
    this.#cancelOpenTimer();
    if (this.#options.canPing) {
      this.#cancelPings = this.#options.clock.every(PING_INTERVAL_MS, () => this.#handlePingTime());
    }
    this.#up.resolve();
    this.measureTime();
  }

  #handlePingTime(): void {
    if (this.#silentPings >= SILENT_PINGS) this.#endSilent(`${SILENT_PINGS} PINGs`);
    else this.#ping();
  }

  #ping({ answered, isExtra = false }: Partial<SentPing> = {}): void {
    const { clock, time } = this.#options;
    if (!isExtra) this.#silentPings += 1;
    this.#pingNumber += 1;
    const number = this.#pingNumber;
    const text = time === undefined ? 'PING' : `PING ${number} ${time.describeClock()}`.trimEnd();
    this.#pings.push({ number, sent: readClocks(clock), isExtra, answered });
    this.#socket.sendText(text);
  }

  #handleSignOfLife(): void {
    this.#silentPings = 0;
    this.#probe.handleFrame();
  }

  #handleBinary(bytes: Uint8Array): void {
    if (this.#failure !== undefined) return;
    this.#handleSignOfLife();
    this.#options.handleBinary(bytes);
  }

  #handleText(text: string): void {
    if (this.#failure !== undefined) return;
    this.#handleSignOfLife();
    if (text === 'PING') this.#socket.sendText('PONG');
    else if (text === 'PONG') this.#handlePong(this.#pings[0]);
    else if (!this.#handleTimedPong(text)) this.#options.handleUnknownText(text);
  }

  #handleTimedPong(text: string): boolean {
    const { time } = this.#options;
    const [, number, masterReceivedMs, masterSentMs] = TIMED_PONG.exec(text) ?? [];
    if (time === undefined || number === undefined) return false;
    const ping = this.#pings.find((one) => one.number === Number(number));
    if (ping === undefined) return true;
    const received = this.#handlePong(ping);
    time.handleExchange({
      sent: ping.sent,
      received,
      masterReceivedMs: Number(masterReceivedMs),
      masterSentMs: Number(masterSentMs),
    });
    return true;
  }

  /** PONGs come in the order of the PINGs; one that was not asked for says nothing. */
  #handlePong(ping: SentPing | undefined): ClockReading {
    const received = readClocks(this.#options.clock);
    if (ping === undefined) return received;
    // A master that was not read from leaves some unanswered.
    for (const one of this.#pings.splice(0, this.#pings.indexOf(ping) + 1)) one.answered?.resolve();
    if (!this.#isUp) this.#handleUp();
    if (!ping.isExtra) {
      this.#tripMs = received.monotonicMs - ping.sent.monotonicMs;
      this.#options.handleRoundTrip(this.#tripMs);
    }
    return received;
  }

  #endSilent(waited: string): void {
    this.#endWithTimeout(`Expected a frame from the master, received none for ${waited}`);
  }

  #endWithTimeout(message: string): void {
    this.#end({
      error: new ConnectionError('timeout', message),
      code: BROKEN,
      wasUp: this.#isUp,
    });
  }

  #end(failure: LinkFailure): void {
    if (this.#failure !== undefined) return;
    this.#finish(failure);
    this.#socket.close();
    this.#options.handleEnd(failure);
  }

  #finish(failure: LinkFailure): void {
    this.#failure = failure;
    this.#cancelOpenTimer();
    this.#cancelPings?.();
    this.#cancelBurst?.();
    this.#probe.cancel();
    for (const ping of this.#pings) ping.answered?.resolve();
    this.#pings = [];
    this.#up.reject(failure);
  }
}
