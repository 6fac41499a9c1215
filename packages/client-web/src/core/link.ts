import { ConnectionError } from './connection-error.ts';
import { Deferred } from './deferred.ts';
import { BROKEN, failureOfClose } from './link-failure.ts';
import type { LinkFailure } from './link-failure.ts';
import type { Cancel, Clock } from './ports/clock.ts';
import type {
  TopicDataQuery,
  TopicDataSocket,
  TopicDataTransport,
} from './ports/topic-data-transport.ts';

/** How often the master is sent a PING. [EX-6] */
export const PING_INTERVAL_MS = 2_000;
/**
 * A socket on which nothing arrived for this many PINGs in a row is dead, though it looks open: the
 * other machine lost power, or the network changed under us. Counted in PINGs and not in time, so
 * that a page whose timers slept does not drop a good link when it wakes.
 */
const SILENT_PINGS = 3;
/** How long a probe waits for a sign of life, milliseconds. */
const PROBE_TIMEOUT_MS = 2_000;

/** What a link is made of. */
export interface LinkOptions {
  readonly transport: TopicDataTransport;
  readonly query: TopicDataQuery;
  readonly clock: Clock;
  /** Whether the master answers PING: masters of ours do. */
  readonly canPing: boolean;
  /** How long opening and the first answer may take, milliseconds. */
  readonly openTimeoutMs: number;
  /** The bytes are the callee's to keep. */
  readonly handleBinary: (bytes: Uint8Array) => void;
  /** A text frame other than PING and PONG. */
  readonly handleUnknownText: (text: string) => void;
  readonly handleRoundTrip: (roundTripMs: number) => void;
  /** Called once, unless `close()` was called before. */
  readonly handleEnd: (failure: LinkFailure) => void;
}

/**
 * One socket from opening to its end. A master of ours may accept a socket only to close it with the
 * code that says why, so there a link counts as up when the first PONG has come.
 */
export class Link {
  /** Resolves when the link is up, rejects with the `LinkFailure` when it ends before. */
  readonly up: Promise<void>;
  /** Never resolves; rejects with the `LinkFailure` when the link ends. */
  readonly ended: Promise<never>;

  readonly #options: LinkOptions;
  readonly #socket: TopicDataSocket;
  readonly #up = new Deferred<void>();
  readonly #ended = new Deferred<never>();
  readonly #cancelOpenTimer: Cancel;
  #cancelPings: Cancel | undefined;
  #cancelProbe: Cancel | undefined;
  #isUp = false;
  #failure: LinkFailure | undefined;
  /** When the PINGs that wait for their PONG were sent, oldest first, and who waits for them. */
  #pings: { sentMs: number; answered: Deferred<void> | undefined }[] = [];
  #silentPings = 0;

  constructor(options: LinkOptions) {
    this.#options = options;
    this.up = this.#up.promise;
    this.ended = this.#ended.promise;
    this.#cancelOpenTimer = options.clock.after(options.openTimeoutMs, () =>
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

  /** Why it ended; `undefined` while it has not. */
  get failure(): LinkFailure | undefined {
    return this.#failure;
  }

  /** Bytes handed over and not yet taken by the system. */
  get bufferedBytes(): number {
    return this.#socket.bufferedBytes;
  }

  sendBinary(borrowedBytes: Uint8Array): void {
    this.#socket.sendBinary(borrowedBytes);
  }

  /** Ends the link as failed when there is no sign of life from the master soon. */
  probe(): void {
    if (!this.isUp || !this.#options.canPing || this.#cancelProbe !== undefined) return;
    this.#ping();
    this.#cancelProbe = this.#options.clock.after(PROBE_TIMEOUT_MS, () =>
      this.#endSilent(`${PROBE_TIMEOUT_MS} ms`),
    );
  }

  /** Resolves when the master has handled all that was sent so far, or the link ended; at once where it cannot be asked. */
  async handled(): Promise<void> {
    if (!this.isUp || !this.#options.canPing) return;
    const answered = new Deferred<void>();
    this.#ping(answered);
    await answered.promise;
  }

  /** Closes the socket without `handleEnd`; idempotent. */
  close(code = 1000, reason = ''): void {
    if (this.#failure !== undefined) return;
    this.#finish({
      error: new ConnectionError('closed', 'The link was closed'),
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
  }

  #handlePingTime(): void {
    if (this.#silentPings >= SILENT_PINGS) this.#endSilent(`${SILENT_PINGS} PINGs`);
    else this.#ping();
  }

  #ping(answered?: Deferred<void>): void {
    this.#silentPings += 1;
    this.#pings.push({ sentMs: this.#options.clock.monotonicMs(), answered });
    this.#socket.sendText('PING');
  }

  #handleSignOfLife(): void {
    this.#silentPings = 0;
    this.#cancelProbe?.();
    this.#cancelProbe = undefined;
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
    else if (text === 'PONG') this.#handlePong();
    else this.#options.handleUnknownText(text);
  }

  #handlePong(): void {
    // PONGs come in the order of the PINGs; one that was not asked for says nothing.
    const ping = this.#pings.shift();
    if (ping === undefined) return;
    ping.answered?.resolve();
    if (!this.#isUp) this.#handleUp();
    this.#options.handleRoundTrip(this.#options.clock.monotonicMs() - ping.sentMs);
  }

  #endSilent(waited: string): void {
    this.#endWithTimeout(`Expected a sign of life from the master, received none for ${waited}`);
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
    this.#cancelProbe?.();
    for (const ping of this.#pings) ping.answered?.resolve();
    this.#pings = [];
    this.#up.reject(failure);
    this.#ended.reject(failure);
  }
}
