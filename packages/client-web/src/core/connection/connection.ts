import type { Cancel, Clock } from '@ubii/timing';
import { ConnectionError } from './connection-error.ts';
import { transition } from './connection-machine.ts';
import { IDLE } from './connection-model.ts';
import type {
  Arrival,
  Farewell,
  MachineContext,
  MachineEffect,
  MachineEvent,
  MachineState,
} from './connection-model.ts';
import type { ConnectionState } from './connection-state.ts';
import { Deferred } from '../callbacks/deferred.ts';
import type { ErrorHandler } from '../ports/error-handler.ts';
import { Link } from './link.ts';
import type { LinkTime } from './link.ts';
import { failureOf, unknownClient } from './link-failure.ts';
import { Listeners } from '../callbacks/listeners.ts';
import type { RandomSource } from '../ports/random.ts';
import type { TopicDataTransport } from '../ports/topic-data-transport.ts';
import type { ReconnectPolicy } from './reconnect-policy.ts';
import type { Membership } from './membership.ts';
import type { Moves } from './moves.ts';
import type { Outage } from './connection-model.ts';
import type { Registration } from './registration.ts';
import type { SendTimes } from './send-times.ts';
import { atDeadline } from '../time/deadline.ts';
import { SleepWatch } from './sleep-watch.ts';

/** Dependencies of a connection. */
export interface ConnectionOptions {
  readonly clock: Clock;
  readonly random: RandomSource;
  readonly policy: ReconnectPolicy;
  readonly registration: Registration;
  readonly transport: TopicDataTransport;
  readonly sendTimes: SendTimes;
  /** Follows the client to another master. */
  readonly moves: Pick<Moves, 'switchTo' | 'switchBack' | 'confirmSwitch'>;
  /** Timeout for opening a socket, milliseconds. */
  readonly openTimeoutMs: number;
  /** The network has changed without an event. */
  readonly freshenServices: () => void;
  readonly handleBinary: (bytes: Uint8Array) => void;
  readonly handleUnknownText: (text: string) => void;
  readonly handleRoundTrip: (roundTripMs: number) => void;
  /** For masters that tell their time. */
  readonly time: LinkTime & { handleLink(): void };
  /** Puts devices and subscriptions back; part of every attempt. A rejection fails the attempt. */
  readonly restore: (arrival: Arrival) => Promise<void>;
  /** A callback of the program failed. */
  readonly onError: ErrorHandler;
}

/** Keeps the client connected: performs what `transition` decides, and reports what comes of it. */
export class Connection {
  readonly #options: ConnectionOptions;
  readonly #stateListeners: Listeners<ConnectionState>;
  readonly #sleepWatch: SleepWatch;
  #state: MachineState = IDLE;
  #connected: Deferred<void> | undefined;
  #link: Link | undefined;
  #registering = Promise.resolve();
  #cancelAttemptTimer: Cancel | undefined;
  #cancelRetry: Cancel | undefined;

  constructor(options: ConnectionOptions) {
    this.#options = options;
    this.#stateListeners = new Listeners(options.onError);
    this.#sleepWatch = new SleepWatch(options.clock, () => this.retryNow()); // [CL-41]
  }

  get state(): ConnectionState {
    return this.#state.announced;
  }

  /** While the own master does not answer. [CU-81] */
  get outage(): Outage | undefined {
    return this.#state.memory.outage;
  }

  /** The link of a connected client. */
  get link(): Link | undefined {
    return this.#state.phase === 'connected' ? this.#link : undefined;
  }

  onState(fn: (state: ConnectionState) => void): () => void {
    return this.#stateListeners.add(fn);
  }

  /** Starts to connect when idle or closed. */
  connect(): Promise<void> {
    this.#handle({ type: 'connect' });
    return this.whenConnected();
  }

  /** Resolves when connected; rejects when nothing is being done about it. */
  whenConnected(): Promise<void> {
    const { state } = this;
    switch (state.status) {
      case 'connected':
        return Promise.resolve();
      case 'idle':
        return Promise.reject(new ConnectionError('closed', 'The client was not connected yet'));
      case 'closed':
        return Promise.reject(state.error ?? new ConnectionError('closed', 'The client is closed'));
      default:
        return (this.#connected ??= new Deferred()).promise;
    }
  }

  /**
   * Tries at once when waiting to try again, and again when an attempt has been under way for a while:
   * the network it was begun on may be gone. When connected, makes sure that the link is alive. [CL-41]
   */
  retryNow(): void {
    this.#handle({ type: 'retry-now' });
  }

  /** Tries at once when waiting to try again: the network is there. [CU-82] */
  recheck(): void {
    this.#handle({ type: 'recheck' });
  }

  /** Tries another master when waiting to try again. [CU-83] */
  switchTo(url: string): void {
    this.#handle({ type: 'switch-master', url });
  }

  /** Ends the link of a connected client as failed, as if it had broken. */
  drop(error: ConnectionError): void {
    this.#handle({ type: 'drop', error });
  }

  /**
   * Stops permanently. The state changes at once; the link is passed on for the last messages.
   * @param farewell what a link is closed with that is not up yet
   * @returns the link, if it is up, and the end of the registration under way
   */
  close(farewell: Farewell = {}): { link: Link | undefined; registered: Promise<void> } {
    const { link } = this;
    this.#handle({ type: 'close', farewell });
    return { link, registered: this.#registering };
  }

  #handle(event: MachineEvent): void {
    const { state, effects } = transition(this.#state, event, this.#context());
    this.#state = state;
    for (const effect of effects) this.#perform(effect);
  }

  #context(): MachineContext {
    const { clock, policy, openTimeoutMs, random, registration } = this.#options;
    return {
      policy,
      openTimeoutMs,
      nowMs: clock.nowMs(),
      monotonicMs: clock.monotonicMs(),
      chance: random(),
      isResumable: registration.isResumable,
      hasCredential: registration.credential !== undefined,
    };
  }

  #perform(effect: MachineEffect): void {
    const { clock, moves, registration } = this.#options;
    switch (effect.type) {
      case 'register':
        return this.#register(effect.attempt);
      case 'cancel-registration':
        return registration.cancel(effect.error);
      case 'switch-to-master':
        return moves.switchTo(effect.url);
      case 'switch-back':
        return moves.switchBack();
      case 'confirm-switch':
        return moves.confirmSwitch();
      case 'trust':
      case 'distrust':
      case 'invalidate':
      case 'forget':
        return registration[effect.type]();
      case 'open-link':
        return this.#openLink(effect.attempt, effect.membership);
      case 'close-link':
        return this.#link?.close(effect.farewell.code, effect.farewell.reason);
      case 'probe-link':
        return this.#link?.probe();
      case 'freshen-services':
        return this.#options.freshenServices();
      case 'check-known':
        return this.#checkKnown(effect.attempt);
      case 'restore':
        return this.#restore(effect.attempt, effect.arrival);
      case 'start-attempt-timer':
        return this.#startAttemptTimer(effect.attempt, effect.attemptTimeoutMs);
      case 'cancel-attempt-timer':
        return this.#cancelAttemptTimer?.();
      case 'start-retry':
        this.#cancelRetry = clock.after(effect.delayMs, () => this.#handle({ type: 'retry-due' }));
        return;
      case 'cancel-retry':
        return this.#cancelRetry?.();
      case 'start-sleep-watch':
        return this.#sleepWatch.start();
      case 'stop-sleep-watch':
        return this.#sleepWatch.stop();
      case 'settle':
        return this.#settle(effect.error);
      case 'announce':
        return this.#stateListeners.emit(effect.state);
    }
  }

  #register(attempt: number): void {
    const { registration } = this.#options;
    this.#registering = this.#step(
      attempt,
      async () => {
        await registration.load();
        this.#handle({ type: 'identity-loaded', clientId: registration.clientId });
        const before = registration.membership;
        const membership = await registration.ensure();
        return { membership, isAnswered: membership !== before };
      },
      (registered) => ({ type: 'registered', attempt, ...registered }),
    );
  }

  #openLink(attempt: number, { identity, isExtended, tellsTime }: Membership): void {
    const { clock, transport, openTimeoutMs, sendTimes, time } = this.#options;
    const open = (): Promise<void> => {
      time.handleLink(); // [TS-8]
      this.#link = new Link({
        transport,
        // An original master knows neither.
        query: {
          clientId: identity.clientId,
          resumeToken: identity.resumeToken,
          sentMs: isExtended ? sendTimes.next() : undefined,
        },
        clock,
        canPing: isExtended,
        openTimeoutMs,
        handleBinary: this.#options.handleBinary,
        handleUnknownText: this.#options.handleUnknownText,
        handleRoundTrip: this.#options.handleRoundTrip,
        time: tellsTime ? time : undefined,
        handleEnd: (failure) => this.#handle({ type: 'failed', attempt, failure }),
      });
      return this.#link.up;
    };
    void this.#step(attempt, open, () => ({ type: 'link-up', attempt }));
  }

  #checkKnown(attempt: number): void {
    const check = async (): Promise<void> => {
      if (!(await this.#options.registration.isKnown())) throw unknownClient();
    };
    void this.#step(attempt, check, () => ({ type: 'known', attempt }));
  }

  #restore(attempt: number, arrival: Arrival): void {
    const restore = (): Promise<void> => this.#options.restore(arrival);
    void this.#step(attempt, restore, () => ({ type: 'restored', attempt }));
  }

  /** Performs a step of an attempt, and reports what comes of it. */
  async #step<T>(
    attempt: number,
    perform: () => Promise<T>,
    toEvent: (result: T) => MachineEvent,
  ): Promise<void> {
    let event: MachineEvent;
    try {
      event = toEvent(await perform());
    } catch (cause) {
      event = { type: 'failed', attempt, failure: failureOf(cause) };
    }
    this.#handle(event);
  }

  #startAttemptTimer(attempt: number, attemptTimeoutMs: number): void {
    this.#cancelAttemptTimer = atDeadline(this.#options.clock, attemptTimeoutMs, () =>
      this.#handle({ type: 'attempt-timeout', attempt, attemptTimeoutMs }),
    );
  }

  #settle(error: ConnectionError | undefined): void {
    const connected = this.#connected;
    this.#connected = undefined;
    if (error === undefined) connected?.resolve();
    else connected?.reject(error);
  }
}
