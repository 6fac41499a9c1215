import { transition } from '../core/connection/connection-machine.ts';
import { IDLE } from '../core/connection/connection-model.ts';
import type {
  MachineContext,
  MachineEffect,
  MachineEvent,
  MachineState,
} from '../core/connection/connection-model.ts';
import { ConnectionError } from '../core/connection/connection-error.ts';
import { BROKEN } from '../core/connection/link-failure.ts';
import type { LinkFailure } from '../core/connection/link-failure.ts';
import { DEFAULT_RECONNECT_POLICY } from '../core/connection/reconnect-policy.ts';
import type { Membership } from '../core/connection/membership.ts';

type Unnumbered<E> = E extends { attempt: number } ? Omit<E, 'attempt'> & { attempt?: number } : E;

/** An event; one of an attempt is of the newest attempt unless it says of which. */
export type RunEvent = Unnumbered<MachineEvent>;

/** Creates the result of a registration. */
export function membershipOf(change: Partial<Membership> & { clientId?: string } = {}): Membership {
  const { clientId = 'client-1', ...rest } = change;
  return {
    identity: { clientId, resumeToken: 'key' },
    isExtended: true,
    tellsTime: false,
    masterVersion: '1.2.3',
    masters: [],
    isInCluster: false,
    role: undefined,
    serial: 1,
    ...rest,
  };
}

/** A link that broke, unless `change` says otherwise. */
export function failureWith(change: Partial<LinkFailure> = {}): LinkFailure {
  return { error: new ConnectionError('closed', 'broke'), code: BROKEN, wasUp: true, ...change };
}

/** One connection machine without the parts that perform its effects. */
export class MachineRun {
  context: MachineContext = {
    policy: DEFAULT_RECONNECT_POLICY,
    openTimeoutMs: 10_000,
    nowMs: 1_000_000,
    monotonicMs: 0,
    chance: 0,
    isResumable: true,
    hasCredential: false,
  };
  state: MachineState = IDLE;

  constructor(context: Partial<MachineContext> = {}) {
    Object.assign(this.context, context);
  }

  /** Lets time pass, milliseconds. */
  pass(ms: number): this {
    const { nowMs, monotonicMs } = this.context;
    this.context = { ...this.context, nowMs: nowMs + ms, monotonicMs: monotonicMs + ms };
    return this;
  }

  /** @returns what is to be done after the last of the events */
  send(...events: readonly RunEvent[]): readonly MachineEffect[] {
    let effects: readonly MachineEffect[] = [];
    for (const event of events) {
      const numbered = { attempt: this.state.memory.attemptId, ...event } as MachineEvent;
      ({ state: this.state, effects } = transition(this.state, numbered, this.context));
    }
    return effects;
  }

  /** From where it can connect, or from a wait, to a connection. */
  arrive(membership: Membership = membershipOf()): this {
    this.send(
      { type: this.state.phase === 'waiting' ? 'retry-due' : 'connect' },
      { type: 'identity-loaded', clientId: '' },
      { type: 'registered', membership, isAnswered: true },
      { type: 'link-up' },
      { type: 'known' },
      { type: 'restored' },
    );
    return this;
  }

  fail(change: Partial<LinkFailure> = {}): readonly MachineEffect[] {
    return this.send({ type: 'failed', failure: failureWith(change) });
  }
}

/** One event of each type, in the order of a first connection. */
export const EVENTS: readonly RunEvent[] = [
  { type: 'connect' },
  { type: 'identity-loaded', clientId: '' },
  { type: 'registered', membership: membershipOf(), isAnswered: true },
  { type: 'link-up' },
  { type: 'known' },
  { type: 'restored' },
  { type: 'failed', failure: failureWith() },
  { type: 'attempt-timeout', attemptTimeoutMs: 2_000 },
  { type: 'retry-due' },
  { type: 'retry-now' },
  { type: 'recheck' },
  { type: 'switch-master', url: 'http://other' },
  { type: 'drop', error: new ConnectionError('refused', 'unknown client') },
  { type: 'close', farewell: {} },
];
