import type { Mapping } from '../mapping/mapping.ts';

/** A message of the other system. */
export interface ForeignMessage<P> {
  readonly address: string;
  /** Not changed later. */
  readonly payload: P;
  readonly sizeBytes: number;
  /** A message without content, which says that the address has no value any more. */
  readonly isEmpty: boolean;
  /** A bridge of the same master sent it: it says so itself. [BR-21] */
  readonly isOurs: boolean;
  /** The system kept it, and gives it because the bridge has subscribed. */
  readonly isKept: boolean;
  /** When it was sent, milliseconds since the Unix epoch, as far as the system says. */
  readonly timestampMs?: number | undefined;
}

/** A message for the other system. */
export interface OutgoingMessage<P> {
  readonly address: string;
  /** `undefined`: the address has no value any more. */
  readonly payload: P | undefined;
  readonly mapping: Mapping;
  /** Time of the value, milliseconds since the Unix epoch, where the record has one. */
  readonly timestampMs?: number | undefined;
}

/** Result of sending: sent, waiting for the connection, or dropped or refused with a reason. */
export type Sent =
  | { readonly kind: 'sent' | 'waiting' }
  | { readonly kind: 'dropped' | 'refused'; readonly reason: string };

/** How the connection to the other system is. */
export type ForeignState =
  | { readonly status: 'connecting' | 'closed' }
  /** `hasForgotten`: it is not the first connection, and what the system kept of this bridge is lost. */
  | { readonly status: 'connected'; readonly hasForgotten: boolean }
  | { readonly status: 'waiting'; readonly reason: string };

/** What happens at the other system. */
export interface ForeignEvents<P> {
  handleMessage(message: ForeignMessage<P>): void;
  /** Something that is no message, or one over the limits, with the reason. */
  handleRefused(reason: string): void;
  /** A message that `send` said is waiting was dropped. */
  handleDropped(mapping: Mapping, reason: string): void;
  handleState(state: ForeignState): void;
  /** What the system keeps for the mappings was given: after each connection, and after each change of the mappings. [BR-14] */
  handleSettled(): void;
}

/** Another system with messages at addresses. Its adapter connects again by itself, after growing pauses. [BR-40] */
export interface ForeignSystem<P> {
  /** Begins to connect. Called once. */
  open(events: ForeignEvents<P>): void;
  /** The mappings that hold from now on: receives what those of direction `in` and `both` select. [BR-4] */
  setMappings(mappings: readonly Mapping[]): void;
  send(message: OutgoingMessage<P>): Sent;
  /** Says whether the bridge reaches the master, as far as the system has that. [BR-41] */
  setAvailable(isAvailable: boolean): void;
  /** Says that the bridge leaves, as far as the system has that, and closes. Nothing is told afterwards. */
  close(): Promise<void>;
}
