import type { ConnectionError } from './connection-error.ts';
import type { ConnectionState, ConnectionStatus } from './connection-state.ts';
import type { LinkFailure } from './link-failure.ts';
import type { ReconnectPolicy } from './reconnect-policy.ts';
import type { Membership } from './membership.ts';

type Announced<S extends ConnectionStatus> = Extract<ConnectionState, { status: S }>;

/** Data that later decisions depend on, in every phase. */
export interface ConnectionMemory {
  /** Number of the newest attempt. Events of earlier attempts are ignored. */
  readonly attemptId: number;
  /** Client id of the last connection or of an earlier run, empty when there was none; `undefined` until it is loaded. */
  readonly lastId: string | undefined;
  /** Counter of the back-off: failed attempts, and connections that broke early. See `ReconnectPolicy`. */
  readonly failedAttempts: number;
  /** Whether this outage has had its one attempt without delay. */
  readonly hasHurried: boolean;
  /** Attempts that took too long, since the last sign that the network works. [CL-43] */
  readonly slowAttempts: number;
  /** Whether the last link fell silent. [CL-43] */
  readonly wasSilent: boolean;
  /** How long the own master has not answered; `undefined` while it does. [CU-81] */
  readonly outage: Outage | undefined;
  /** Whether the attempt under way is one at another master. [CU-83] */
  readonly hasSwitched: boolean;
}

/** A time in which the own master does not answer; monotonic milliseconds. */
export interface Outage {
  /** When the link was lost, or the first attempt without an answer failed. */
  readonly sinceMs: number;
  /** Start of the last attempt that failed; `undefined` before. */
  readonly failedStartMs: number | undefined;
}

interface Attempting<P> {
  readonly phase: P;
  readonly announced: Announced<'connecting' | 'reconnecting'>;
  /** Start of the attempt, monotonic milliseconds. */
  readonly startedMs: number;
}

interface Linked<P> extends Attempting<P> {
  readonly membership: Membership;
}

/** The state of the machine. `announced` is what the program sees of it. */
export type MachineState = { readonly memory: ConnectionMemory } & (
  | { readonly phase: 'idle'; readonly announced: Announced<'idle'> }
  /** Loads the identity and makes sure that the master knows the client; there is no link. */
  | Attempting<'registering'>
  | Linked<'opening'>
  /** The link is up: asks an original master whether it knows the client. */
  | Linked<'checking'>
  /** Puts devices and subscriptions back. */
  | Linked<'restoring'>
  | {
      readonly phase: 'connected';
      readonly announced: Announced<'connected'>;
      /** Start of the connection, monotonic milliseconds. */
      readonly connectedMs: number;
    }
  /** Waits for the time of the next attempt; there is no link. */
  | { readonly phase: 'waiting'; readonly announced: Announced<'reconnecting'> }
  | { readonly phase: 'closed'; readonly announced: Announced<'closed'> }
);

/** State of the client on the master at the time of an attempt. */
export interface Arrival {
  readonly membership: Membership;
  /** The id before this arrival; empty for the first one. */
  readonly previousId: string;
}

/** The close code of a client that closes a link that is not up yet, and its reason. */
export interface Farewell {
  readonly code?: number;
  readonly reason?: string;
}

/** An event of one attempt, or of the connection that it led to. */
export type AttemptEvent = { readonly attempt: number } &
  /** `isAnswered`: the master was asked, and did not only seem to know the client. */
  (
    | { readonly type: 'registered'; readonly membership: Membership; readonly isAnswered: boolean }
    | { readonly type: 'link-up' }
    /** An original master knows the client. */
    | { readonly type: 'known' }
    | { readonly type: 'restored' }
    /** A step of the attempt failed, or the link ended. */
    | { readonly type: 'failed'; readonly failure: LinkFailure }
    /** The attempt took longer than it may. */
    | { readonly type: 'attempt-timeout'; readonly attemptTimeoutMs: number }
  );

/** Event of the connection. */
export type MachineEvent =
  | AttemptEvent
  | { readonly type: 'connect' }
  /** The network may work again. [CL-41] */
  | { readonly type: 'retry-now' }
  | { readonly type: 'retry-due' }
  /** Another master answers: the own one is asked again at once. [CU-82] */
  | { readonly type: 'recheck' }
  /** The own one did not answer then. [CU-82] */
  | { readonly type: 'switch-master'; readonly url: string }
  /** The link of a connected client does not work. */
  | { readonly type: 'drop'; readonly error: ConnectionError }
  | { readonly type: 'close'; readonly farewell: Farewell }
  /** The identity of an earlier run was loaded; the id is empty when there was none. */
  | { readonly type: 'identity-loaded'; readonly clientId: string };

/** Time, chance and settings at the time of an event. */
export interface MachineContext {
  readonly policy: ReconnectPolicy;
  /** Timeout for opening a socket, milliseconds. */
  readonly openTimeoutMs: number;
  /** Milliseconds since the Unix epoch. */
  readonly nowMs: number;
  readonly monotonicMs: number;
  /** For the jitter of a delay: uniform in [0, 1). */
  readonly chance: number;
  /** Whether registering again, even twice at once, makes no second client. [CL-3] */
  readonly isResumable: boolean;
  /** Whether the client has joined. [AC-13] */
  readonly hasCredential: boolean;
}

/** Action after an event, in this order. `announce` comes last: its callbacks may cause further events. */
export type MachineEffect =
  | { readonly type: 'register'; readonly attempt: number }
  | { readonly type: 'cancel-registration'; readonly error: ConnectionError }
  /** The attempts from here on are at another master; at the own one again; the other one is the own one from now on. */
  | { readonly type: 'switch-to-master'; readonly url: string }
  | { readonly type: 'switch-back' | 'confirm-switch' }
  /** Whether the client's knowledge of its registration is valid, unverified or invalid; or the identity is discarded. */
  | { readonly type: 'trust' | 'distrust' | 'invalidate' | 'forget' }
  | { readonly type: 'open-link'; readonly attempt: number; readonly membership: Membership }
  | { readonly type: 'close-link'; readonly farewell: Farewell }
  | { readonly type: 'probe-link' }
  | { readonly type: 'freshen-services' }
  | { readonly type: 'check-known'; readonly attempt: number }
  | { readonly type: 'restore'; readonly attempt: number; readonly arrival: Arrival }
  | {
      readonly type: 'start-attempt-timer';
      readonly attempt: number;
      readonly attemptTimeoutMs: number;
    }
  | { readonly type: 'start-retry'; readonly delayMs: number }
  | { readonly type: 'cancel-attempt-timer' | 'cancel-retry' }
  | { readonly type: 'start-sleep-watch' | 'stop-sleep-watch' }
  /** Resolves the promises of those who wait for the connection, or rejects them. */
  | { readonly type: 'settle'; readonly error: ConnectionError | undefined }
  | { readonly type: 'announce'; readonly state: ConnectionState };

/** The state after an event, and what is to be done. */
export interface Step {
  readonly state: MachineState;
  readonly effects: readonly MachineEffect[];
}

/** The state of a client that was not connected yet. */
export const IDLE: MachineState = {
  phase: 'idle',
  announced: { status: 'idle' },
  memory: {
    attemptId: 0,
    lastId: undefined,
    failedAttempts: 0,
    hasHurried: false,
    slowAttempts: 0,
    wasSilent: false,
    outage: undefined,
    hasSwitched: false,
  },
};
