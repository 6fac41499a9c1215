import fc from 'fast-check';
import { expect, it } from 'vitest';
import { EVENTS, MachineRun, failureWith, membershipOf } from '../../testing/machine-run.ts';
import type { RunEvent } from '../../testing/machine-run.ts';
import { ConnectionError } from './connection-error.ts';
import type { MachineEffect } from './connection-model.ts';
import type { ConnectionStatus } from './connection-state.ts';
import { isLive } from './connection-ending.ts';
import { DEFAULT_RECONNECT_POLICY } from './reconnect-policy.ts';

/** Statuses that may follow each status. */
const MOVES: Record<ConnectionStatus, readonly ConnectionStatus[]> = {
  idle: ['connecting', 'closed'],
  connecting: ['connected', 'reconnecting', 'closed'],
  connected: ['reconnecting', 'closed'],
  reconnecting: ['connected', 'reconnecting', 'closed'],
  closed: ['connecting', 'closed'],
};

/** Keeps account of what the effects open and close. */
class Ledger {
  status: ConnectionStatus = 'idle';
  /** Open resources: `link`, `retry`, `attempt-timer`, `sleep-watch`, `waiter`. */
  readonly open = new Set<string>();
  readonly attempts: number[] = [];

  apply(effects: readonly MachineEffect[], isClose: boolean): void {
    effects.forEach((effect, index) => {
      if ('attempt' in effect) this.#handleAttempt(effect);
      const [, start, timer] =
        /^(start|stop|cancel)-(retry|attempt-timer|sleep-watch)$/.exec(effect.type) ?? [];
      if (timer !== undefined && start === 'start') this.#add(timer);
      else if (timer !== undefined) this.open.delete(timer);
      if (effect.type === 'open-link') this.#add('link');
      if (effect.type === 'close-link') this.#remove('link');
      if (effect.type === 'probe-link') expect(this.open).toContain('link');
      if (effect.type === 'settle') this.open.delete('waiter');
      if (effect.type !== 'announce') return;
      expect(index).toBe(effects.length - 1); // its callbacks may cause further events
      expect(MOVES[this.status]).toContain(effect.state.status);
      this.status = effect.state.status;
      if (this.status === 'connecting') this.open.add('waiter');
      if (this.status === 'reconnecting') this.open.add('waiter');
    });
    if (isClose) this.open.delete('link'); // its caller has it
  }

  #handleAttempt(effect: Extract<MachineEffect, { attempt: number }>): void {
    const newest = this.attempts.at(-1) ?? 0;
    if (effect.type === 'register') this.attempts.push(effect.attempt);
    if (effect.type === 'register') expect(effect.attempt).toBeGreaterThan(newest);
    else if (effect.type !== 'start-attempt-timer') expect(effect.attempt).toBe(newest);
  }

  #add(what: string): void {
    expect(this.open).not.toContain(what);
    this.open.add(what);
  }

  #remove(what: string): void {
    expect(this.open).toContain(what);
    this.open.delete(what);
  }
}

/** Resources that are open in each phase; `attempt-timer` may be open during an attempt. */
const OPEN = {
  idle: [],
  registering: ['waiter'],
  opening: ['link', 'waiter'],
  checking: ['link', 'waiter'],
  restoring: ['link', 'waiter'],
  connected: ['link', 'sleep-watch'],
  waiting: ['retry', 'waiter'],
  closed: [],
};

/** Event that each phase waits for, so that random events make progress often enough. */
const DUE: Record<keyof typeof OPEN, RunEvent> = {
  idle: { type: 'connect' },
  registering: {
    type: 'registered',
    membership: membershipOf({ isExtended: false }),
    isAnswered: true,
  },
  opening: { type: 'link-up' },
  checking: { type: 'known' },
  restoring: { type: 'restored' },
  connected: { type: 'failed', failure: failureWith() },
  waiting: { type: 'retry-due' },
  closed: { type: 'connect' },
};

const failures = fc
  .record({
    reason: fc.constantFrom('closed', 'refused', 'timeout', 'protocol', 'join' as const),
    code: fc.constantFrom(1000, 1001, 1006, 4001, 4003, 4004, 4008, 4010, 4011, 4012),
    wasUp: fc.boolean(),
  })
  .map(({ reason, code, wasUp }) =>
    failureWith({ error: new ConnectionError(reason, 'why'), code, wasUp }),
  );
const steps = fc.record({
  event: fc.oneof(
    { weight: 4, arbitrary: fc.constant(undefined) }, // what is due
    { weight: 2, arbitrary: fc.constantFrom(...EVENTS) },
    failures.map((failure): RunEvent => ({ type: 'failed', failure })),
    fc
      .record({
        membership: fc
          .record({ clientId: fc.constantFrom('client-1', 'client-2'), isExtended: fc.boolean() })
          .map(membershipOf),
        isAnswered: fc.boolean(),
      })
      .map((registered): RunEvent => ({ type: 'registered', ...registered })),
  ),
  /** Number of attempts by which the event is late. */
  late: fc.constantFrom(0, 0, 0, 0, 1, 2),
  passMs: fc.constantFrom(0, 10, 900, 1_100, 6_000),
  context: fc.record({
    chance: fc.double({ min: 0, max: 1, noNaN: true, maxExcluded: true }),
    isResumable: fc.boolean(),
    hasCredential: fc.boolean(),
  }),
});
const policies = fc.constantFrom(1, 3, Infinity).map((giveUpAfterAttempts) => ({
  ...DEFAULT_RECONNECT_POLICY,
  giveUpAfterAttempts,
}));

it('any order of events leaves open what the phase needs, and nothing else', () => {
  const phases = new Set<string>();
  fc.assert(
    fc.property(policies, fc.array(steps, { maxLength: 60 }), (policy, all) => {
      const run = new MachineRun({ policy });
      const ledger = new Ledger();
      for (const { event: chosen, late, passMs, context } of all) {
        Object.assign(run.pass(passMs).context, context);
        const before = run.state;
        const event = chosen ?? DUE[before.phase];
        const attempt = before.memory.attemptId - late;
        const effects = run.send({ ...event, attempt } as RunEvent);
        if (event.type === 'retry-due') ledger.open.delete('retry');
        if (event.type === 'attempt-timeout' && late === 0) ledger.open.delete('attempt-timer');
        ledger.apply(effects, event.type === 'close');
        const { state } = run;
        phases.add(state.phase);
        const mayBePatient = isLive(state) && state.phase !== 'connected';
        const open = [...ledger.open].filter((what) => what !== 'attempt-timer' || !mayBePatient);
        expect(open.sort()).toEqual(OPEN[state.phase]);
        expect(ledger.status).toBe(state.announced.status);
        if (event.type !== 'connect' && before.phase === 'closed') {
          expect(state.phase).toBe('closed');
        }
        if (state.phase !== 'waiting') continue;
        const latestMs = run.context.nowMs + policy.maxDelayMs;
        expect(state.announced.nextAttemptMs).toBeLessThanOrEqual(latestMs);
      }
    }),
    { numRuns: 2_000, seed: 17 },
  );
  expect([...phases].sort()).toEqual(Object.keys(OPEN).sort());
  // Thousands of runs take seconds on a busy machine; none waits for a time to pass.
}, 60_000);
