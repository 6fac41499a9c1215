import type { Cancel, Clock } from '@ubii/timing';
import { ConnectionError } from './connection-error.ts';
import { next } from './connection-state.ts';
import type { ConnectionEvent, ConnectionState } from './connection-state.ts';
import { Deferred } from './deferred.ts';
import { Link } from './link.ts';
import type { LinkTime } from './link.ts';
import { BROKEN, failureOf, isAnswered, isTold, remedyFor, unknownClient } from './link-failure.ts';
import type { LinkFailure } from './link-failure.ts';
import { Listeners } from './listeners.ts';
import type { RandomSource } from './ports/random.ts';
import type { TopicDataTransport } from './ports/topic-data-transport.ts';
import { reconnectDelayMs } from './reconnect-policy.ts';
import type { ReconnectPolicy } from './reconnect-policy.ts';
import type { Membership, Registration } from './registration.ts';
import { SleepWatch } from './sleep-watch.ts';

/** How an attempt found the client at the master. */
export interface Arrival {
  readonly membership: Membership;
  /** The id before this arrival; empty for the first one. */
  readonly previousId: string;
}

/** What a connection is made of. */
export interface ConnectionOptions {
  readonly clock: Clock;
  readonly random: RandomSource;
  readonly policy: ReconnectPolicy;
  readonly registration: Registration;
  readonly transport: TopicDataTransport;
  /** How long opening a socket may take, milliseconds. */
  readonly openTimeoutMs: number;
  /** The network is another one than before, and nothing said so. */
  readonly freshenServices: () => void;
  readonly handleBinary: (bytes: Uint8Array) => void;
  readonly handleUnknownText: (text: string) => void;
  readonly handleRoundTrip: (roundTripMs: number) => void;
  /** For masters that tell their time. */
  readonly time: LinkTime & { handleLink(): void };
  /** Puts devices and subscriptions back; part of every attempt. A rejection fails the attempt. */
  readonly restore: (arrival: Arrival) => Promise<void>;
}

/** An attempt younger than this is left alone by `retryNow`, milliseconds. */
const FRESH_ATTEMPT_MS = 1_000;

/**
 * How long the first attempts to come back may take until the link is up, milliseconds. It doubles
 * with each that took too long: the network may be gone, or the machine busy. [CL-43]
 */
const FIRST_PATIENCE_MS = 2_000;

/** An attempt under way. */
interface Attempt {
  readonly done: Promise<void>;
  readonly startedMs: number;
  cancelPatience: Cancel | undefined;
}

/** Thrown inside an attempt that was given up meanwhile; goes no further. */
const ABANDONED = Symbol('abandoned');

/** Keeps the client connected: attempts, back-off, and the state that others see. */
export class Connection {
  readonly #options: ConnectionOptions;
  readonly #stateListeners = new Listeners<ConnectionState>();
  #state: ConnectionState = { status: 'idle' };
  #connected: Deferred<void> | undefined;
  #link: Link | undefined;
  /** Stands for the attempt under way; replaced to abandon it. */
  #attempt: Attempt | undefined;
  #cancelRetry: Cancel | undefined;
  /** The id of the last connection, or of an earlier run; empty when there was none. */
  #lastId: string | undefined;
  /** What the back-off counts: failed attempts, and links that did not hold. See `ReconnectPolicy`. */
  #failedAttempts = 0;
  /** Attempts since the last connection, the one under way included. */
  #attemptNumber = 0;
  /** Whether this outage has had its one attempt without delay. */
  #hasHurried = false;
  /** The next attempt is to start without delay. */
  #mustHurry = false;
  #connectedSinceMs = 0;
  /** Attempts that took too long, since the last sign that the way is free. */
  #slowAttempts = 0;
  /** The link before fell silent. */
  #wasSilent = false;
  readonly #sleepWatch: SleepWatch;

  constructor(options: ConnectionOptions) {
    this.#options = options;
    this.#sleepWatch = new SleepWatch(options.clock, () => this.retryNow()); // [CL-41]
  }

  get state(): ConnectionState {
    return this.#state;
  }

  /** The link of a connected client. */
  get link(): Link | undefined {
    return this.#state.status === 'connected' ? this.#link : undefined;
  }

  onState(fn: (state: ConnectionState) => void): () => void {
    return this.#stateListeners.add(fn);
  }

  /** Starts to connect when idle or closed. */
  connect(): Promise<void> {
    if (this.#state.status === 'idle' || this.#state.status === 'closed') {
      this.#failedAttempts = 0;
      this.#attemptNumber = 0;
      this.#hasHurried = false;
      this.#mustHurry = false;
      this.#move('connect', { status: 'connecting', attempt: 1 });
      this.#startAttempt();
    }
    return this.whenConnected();
  }

  /** Resolves when connected; rejects when nothing is being done about it. */
  whenConnected(): Promise<void> {
    switch (this.#state.status) {
      case 'connected':
        return Promise.resolve();
      case 'idle':
        return Promise.reject(new ConnectionError('closed', 'The client was not connected yet'));
      case 'closed':
        return Promise.reject(
          this.#state.error ?? new ConnectionError('closed', 'The client is closed'),
        );
      default:
        return (this.#connected ??= new Deferred()).promise;
    }
  }

  /**
   * Tries at once when waiting to try again, and again when an attempt has been under way for a while:
   * the network it was begun on may be gone. When connected, makes sure that the link is alive. [CL-41]
   */
  retryNow(): void {
    this.#slowAttempts = 0;
    if (this.#state.status === 'connected') {
      this.#link?.probe();
    } else if (this.#cancelRetry !== undefined) {
      this.#options.registration.trust();
      this.#failedAttempts = 0;
      this.#cancelRetry();
      this.#startAttempt();
    } else if (this.#attempt !== undefined && this.#mayAbandon()) {
      const ageMs = this.#options.clock.monotonicMs() - this.#attempt.startedMs;
      if (ageMs < FRESH_ATTEMPT_MS) return;
      this.#mustHurry = true;
      this.#abandon(`The attempt was given up after ${Math.round(ageMs)} ms for a new one`);
    }
  }

  /** Ends the link of a connected client as failed, as if it had broken. */
  drop(error: ConnectionError): void {
    if (this.#state.status === 'connected')
      this.#handleFailure({ error, code: BROKEN, wasUp: true });
  }

  /**
   * Stops permanently. The state changes at once; the link is handed over for what is left to be said.
   * @param farewell what a link is closed with that is not up yet
   * @returns the link, if it is up, and the end of the attempt under way
   */
  close(farewell: { readonly code?: number; readonly reason?: string } = {}): {
    link: Link | undefined;
    attemptDone: Promise<void>;
  } {
    const link = this.link;
    const attemptDone = this.#attempt?.done ?? Promise.resolve();
    if (link === undefined) this.#link?.close(farewell.code, farewell.reason);
    this.#link = undefined;
    this.#stop('close', undefined);
    return { link, attemptDone };
  }

  #startAttempt(): void {
    const { clock, openTimeoutMs } = this.#options;
    this.#cancelRetry = undefined;
    this.#attemptNumber += 1;
    const done = new Deferred<void>();
    const attempt: Attempt = {
      done: done.promise,
      startedMs: clock.monotonicMs(),
      cancelPatience: undefined,
    };
    this.#attempt = attempt;
    const patienceMs = FIRST_PATIENCE_MS * 2 ** this.#slowAttempts;
    if (this.#state.status === 'reconnecting' && patienceMs < openTimeoutMs) {
      attempt.cancelPatience = clock.after(patienceMs, () => this.#losePatience(patienceMs));
    }
    const isCurrent = (): boolean => this.#attempt === attempt;
    this.#arrive(isCurrent)
      .catch((cause: unknown) => {
        if (isCurrent()) this.#handleFailure(failureOf(cause));
      })
      .finally(() => done.resolve());
  }

  #losePatience(patienceMs: number): void {
    if (!this.#mayAbandon()) return;
    this.#slowAttempts += 1;
    this.#abandon(`Expected the master to answer within ${patienceMs} ms`);
  }

  /** Before the link is up nothing is lost, unless a second registration would make a second client. */
  #mayAbandon(): boolean {
    if (this.#link !== undefined) return !this.#link.isUp;
    return this.#options.registration.isResumable;
  }

  #abandon(message: string): void {
    const error = new ConnectionError('closed', message);
    this.#handleFailure({ error, code: BROKEN, wasUp: false });
    this.#options.registration.cancel(error);
  }

  #endAttempt(): void {
    this.#attempt?.cancelPatience?.();
    this.#attempt = undefined;
  }

  async #arrive(isCurrent: () => boolean): Promise<void> {
    const { registration } = this.#options;
    await registration.load();
    // An attempt that failed half-way may have changed the id already.
    this.#lastId ??= registration.clientId;
    const previousId = this.#lastId;
    const membership = await registration.ensure();
    if (!isCurrent()) throw ABANDONED;
    const link = this.#openLink(membership);
    await link.up;
    if (this.#wasSilent) this.#options.freshenServices();
    this.#wasSilent = false;
    if (!membership.isExtended && !(await registration.isKnown())) throw unknownClient();
    const arrival: Arrival = { membership, previousId };
    await Promise.race([this.#options.restore(arrival), link.ended]);
    if (!isCurrent()) throw ABANDONED;
    if (link.failure !== undefined) throw link.failure; // ended in the turn between
    this.#handleArrival(arrival);
  }

  #openLink({ identity, isExtended, tellsTime }: Membership): Link {
    const { clock, transport, openTimeoutMs, time } = this.#options;
    time.handleLink(); // [TS-8]
    const link: Link = new Link({
      transport,
      // An original master knows no tokens.
      query: { clientId: identity.clientId, resumeToken: identity.resumeToken },
      clock,
      canPing: isExtended,
      openTimeoutMs,
      handleBinary: this.#options.handleBinary,
      handleUnknownText: this.#options.handleUnknownText,
      handleRoundTrip: this.#options.handleRoundTrip,
      time: tellsTime ? time : undefined,
      handleEnd: (failure) => {
        if (this.#link === link && this.#state.status === 'connected') this.#handleFailure(failure);
      },
    });
    this.#link = link;
    return link;
  }

  #handleArrival({ membership, previousId }: Arrival): void {
    this.#endAttempt();
    this.#sleepWatch.start();
    this.#slowAttempts = 0;
    this.#attemptNumber = 0;
    this.#hasHurried = false;
    this.#connectedSinceMs = this.#options.clock.monotonicMs();
    const { clientId } = membership.identity;
    this.#lastId = clientId;
    const connected = this.#connected;
    this.#connected = undefined;
    this.#move('established', {
      status: 'connected',
      clientId,
      resumed: clientId === previousId,
      masterVersion: membership.masterVersion,
      sinceMs: this.#options.clock.nowMs(),
    });
    connected?.resolve();
  }

  #handleFailure(failure: LinkFailure): void {
    const { registration, clock, policy, random } = this.#options;
    this.#endAttempt();
    this.#sleepWatch.stop();
    const hadLink = this.#link !== undefined;
    if (failure.wasUp && failure.error.reason === 'timeout') this.#wasSilent = true;
    this.#link?.close();
    this.#link = undefined;
    const remedy = remedyFor(failure);
    if (remedy === 'stop') {
      // Not ours any more, so `close()` must not deregister it; `connect()` may take it back.
      const { reason } = failure.error;
      if (reason === 'superseded' || reason === 'disconnected' || reason === 'join') {
        registration.invalidate();
      }
      this.#stop('ended', failure.error);
      return;
    }
    if (remedy === 'register-as-new') registration.forget();
    if (remedy === 'register-again') {
      if (isTold(failure)) registration.invalidate();
      else registration.doubt();
    }
    // A socket that is refused silently: services say why, and a browser is not told. [AC-27]
    const isMute =
      hadLink && failure.code === BROKEN && !failure.wasUp && failure.error.cause === undefined;
    if (remedy === 'retry' && isMute && registration.credential !== undefined) registration.doubt();

    // The master is there and said what to do: once in an outage that is done without delay.
    const hurries = this.#mustHurry || (isTold(failure) && !this.#hasHurried);
    this.#mustHurry = false;
    if (hurries) this.#hasHurried = true;
    else if (this.#state.status !== 'connected') this.#failedAttempts += 1;
    else if (clock.monotonicMs() - this.#connectedSinceMs >= policy.stableAfterMs) {
      this.#failedAttempts = 0;
    } else this.#failedAttempts += 1;

    const delayMs = reconnectDelayMs(policy, this.#failedAttempts, random, isAnswered(failure));
    if (delayMs === undefined) {
      this.#stop('ended', failure.error);
      return;
    }
    const waitMs = hurries ? 0 : delayMs;
    this.#cancelRetry = clock.after(waitMs, () => this.#startAttempt());
    this.#move('failed', {
      status: 'reconnecting',
      attempt: this.#attemptNumber + 1,
      nextAttemptMs: clock.nowMs() + waitMs,
      error: failure.error,
    });
  }

  #stop(event: 'ended' | 'close', error: ConnectionError | undefined): void {
    this.#endAttempt();
    this.#sleepWatch.stop();
    this.#cancelRetry?.();
    this.#cancelRetry = undefined;
    const connected = this.#connected;
    this.#connected = undefined;
    this.#move(event, { status: 'closed', error });
    connected?.reject(error ?? new ConnectionError('closed', 'The client was closed'));
  }

  #move(event: ConnectionEvent, state: ConnectionState): void {
    const { status } = this.#state;
    if (next(status, event) !== state.status) {
      throw new Error(`Expected a move from "${status}", received "${event}" to "${state.status}"`);
    }
    this.#state = state;
    this.#stateListeners.emit(state);
  }
}
