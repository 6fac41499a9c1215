import { ServiceError } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { EVENTS, MachineRun, membershipOf } from '../../testing/machine-run.ts';
import type { RunEvent } from '../../testing/machine-run.ts';
import { ConnectionError } from './connection-error.ts';
import type { MachineEffect } from './connection-model.ts';
import { unknownClient } from './link-failure.ts';
import { DEFAULT_RECONNECT_POLICY } from './reconnect-policy.ts';

const CONNECT: readonly RunEvent[] = [
  { type: 'connect' },
  { type: 'identity-loaded', clientId: '' },
];
const ORIGINAL: RunEvent = {
  type: 'registered',
  membership: membershipOf({ isExtended: false }),
  isAnswered: true,
};
const OURS = {
  type: 'registered',
  membership: membershipOf(),
  isAnswered: true,
} satisfies RunEvent;
const UP: RunEvent = { type: 'link-up' };

/** The events that lead to each phase. */
const WAYS = {
  idle: [],
  registering: CONNECT,
  opening: [...CONNECT, OURS],
  checking: [...CONNECT, ORIGINAL, UP],
  restoring: [...CONNECT, OURS, UP],
  connected: [...CONNECT, OURS, UP, { type: 'restored' }],
  waiting: [...CONNECT, { type: 'failed', failure: failure('refused') }],
  closed: [...CONNECT, { type: 'close', farewell: {} }],
} as const satisfies Record<string, readonly RunEvent[]>;

function failure(reason: ConnectionError['reason'], code = 1006, wasUp = false, cause?: unknown) {
  return { error: new ConnectionError(reason, 'why', { cause }), code, wasUp };
}

const FORBIDDEN = new ServiceError('permission_denied', 'no');

function types(effects: readonly MachineEffect[]): string {
  return effects.map(({ type }) => type).join(', ');
}

function runTo(
  phase: keyof typeof WAYS,
  context: ConstructorParameters<typeof MachineRun>[0] = {},
) {
  const run = new MachineRun(context);
  run.send(...WAYS[phase]);
  expect(run.state.phase).toBe(phase);
  return run.pass(1_000);
}

describe('transition()', () => {
  it('has exactly these moves', () => {
    const moves = Object.keys(WAYS).flatMap((phase) =>
      EVENTS.map((event) => {
        const run = runTo(phase as keyof typeof WAYS);
        const before = run.state;
        const effects = run.send(event);
        if (effects.length === 0 && run.state.phase === phase) {
          expect({ ...run.state, memory: before.memory }).toEqual(before);
          return '';
        }
        return `${phase} + ${event.type} = ${run.state.phase}: ${types(effects)}`;
      }),
    );
    expect(moves.filter((move) => move !== '')).toEqual([
      'idle + connect = registering: register, announce',
      'idle + close = closed: settle, announce',
      'registering + registered = opening: cancel-attempt-timer, open-link',
      'registering + failed = waiting: cancel-attempt-timer, start-retry, announce',
      'registering + attempt-timeout = waiting: cancel-registration, cancel-attempt-timer, start-retry, announce',
      'registering + retry-now = waiting: cancel-registration, cancel-attempt-timer, start-retry, announce',
      'registering + close = closed: cancel-attempt-timer, settle, announce',
      'opening + link-up = restoring: restore',
      'opening + failed = waiting: cancel-attempt-timer, close-link, start-retry, announce',
      'opening + attempt-timeout = waiting: cancel-registration, cancel-attempt-timer, close-link, start-retry, announce',
      'opening + retry-now = waiting: cancel-registration, cancel-attempt-timer, close-link, start-retry, announce',
      'opening + close = closed: cancel-attempt-timer, close-link, settle, announce',
      'checking + known = restoring: restore',
      'checking + failed = waiting: cancel-attempt-timer, close-link, start-retry, announce',
      'checking + close = closed: cancel-attempt-timer, close-link, settle, announce',
      'restoring + restored = connected: cancel-attempt-timer, start-sleep-watch, settle, announce',
      'restoring + failed = waiting: cancel-attempt-timer, close-link, start-retry, announce',
      'restoring + close = closed: cancel-attempt-timer, close-link, settle, announce',
      'connected + failed = waiting: stop-sleep-watch, close-link, start-retry, announce',
      'connected + retry-now = connected: probe-link',
      'connected + drop = waiting: stop-sleep-watch, close-link, start-retry, announce',
      'connected + close = closed: stop-sleep-watch, settle, announce',
      'waiting + retry-due = registering: start-attempt-timer, register',
      'waiting + retry-now = registering: cancel-retry, trust, start-attempt-timer, register',
      'waiting + recheck = registering: cancel-retry, start-attempt-timer, register',
      'waiting + switch-master = registering: cancel-retry, switch-to-master, register',
      'waiting + close = closed: cancel-retry, settle, announce',
      'closed + connect = registering: register, announce',
      'closed + close = closed: settle, announce',
    ]);
  });

  it('ignores the events of an attempt before', () => {
    const run = runTo('opening');
    run.fail();
    run.send({ type: 'retry-due' });
    const before = run.state;
    for (const event of EVENTS.slice(2, 8)) {
      expect(run.send({ ...event, attempt: 1 } as RunEvent)).toEqual([]);
    }
    expect(run.state).toEqual(before);
  });

  it.each([
    ['close code 4001', 'closed', 'invalidate', failure('superseded', 4001, true)],
    ['close code 4010', 'closed', 'invalidate', failure('disconnected', 4010, true)],
    ['close code 4011', 'closed', 'invalidate', failure('join', 4011, true)],
    ['close code 4003', 'waiting', 'forget', failure('closed', 4003, true)],
    ['close code 4004', 'waiting', 'invalidate', failure('closed', 4004, true)],
    ['close code 1000', 'waiting', 'invalidate', failure('closed', 1000, true)],
    ['a socket that says nothing', 'waiting', 'distrust', failure('timeout')],
    ['a socket that is refused silently', 'waiting', 'distrust', failure('closed')],
    ['not_found', 'waiting', 'invalidate', failure('refused', 1006, false, unknownClient())],
    ['permission_denied', 'closed', 'none', failure('refused', 1006, false, FORBIDDEN)],
    ['a link that broke', 'waiting', 'none', failure('closed', 1006, true)],
  ] as const)('after %s it is %s, and the registration: %s [EX-5] [AC-27]', (...row) => {
    const [, phase, order, of] = row;
    const run = runTo('opening', { hasCredential: true });
    const effects = run.send({ type: 'failed', failure: of });
    const orders = ['trust', 'distrust', 'invalidate', 'forget'];
    expect(run.state.phase).toBe(phase);
    expect(effects.find(({ type }) => orders.includes(type))?.type ?? 'none').toBe(order);
  });

  it('has no doubt after a socket that is refused silently when it has not joined', () => {
    expect(types(runTo('opening').fail({ wasUp: false }))).not.toContain('distrust');
  });
});

describe('an attempt at another master [CU-83]', () => {
  const switched = () => {
    const run = runTo('connected');
    run.fail();
    run.send({ type: 'switch-master', url: 'http://other' });
    return run;
  };

  it('that succeeds keeps it', () => {
    const run = switched();
    const effects = run.send(OURS, UP, { type: 'restored' });
    expect(types(effects)).toBe(
      'cancel-attempt-timer, confirm-switch, start-sleep-watch, settle, announce',
    );
    expect(types(run.fail())).not.toContain('switch-back');
  });

  it.each([
    ['a refusal', failure('refused', 1006, false, FORBIDDEN)],
    ['close code 4003', failure('closed', 4003, true)],
    ['close code 4010', failure('disconnected', 4010, true)],
    ['silence', failure('timeout')],
  ] as const)('that ends with %s leads back to the own master, as it was', (_, why) => {
    const run = switched();
    run.send(OURS);
    expect(types(run.send({ type: 'failed', failure: why }))).toBe(
      'cancel-attempt-timer, close-link, switch-back, start-retry, announce',
    );
    expect(run.state.phase).toBe('waiting');
  });

  it('that a program closed is one at the own master when it connects again', () => {
    const run = switched();
    run.send({ type: 'close', farewell: {} });
    expect(types(run.send({ type: 'connect' }))).toBe('switch-back, register, announce');
  });
});

describe('the delay before the next attempt', () => {
  function delayAfter(effects: readonly MachineEffect[]): number | undefined {
    return effects.find((effect) => effect.type === 'start-retry')?.delayMs;
  }

  it('is none after what the master said, once in an outage', () => {
    const run = runTo('connected');
    const told = { ...failure('closed', 4004, true) };
    expect(delayAfter(run.fail(told))).toBe(0);
    run.send({ type: 'retry-due' }, OURS);
    expect(delayAfter(run.fail(told))).toBeGreaterThan(0);
    run.arrive();
    expect(delayAfter(run.fail(told))).toBe(0);
  });

  it('grows with failed attempts and with links that break early, not with one that held', () => {
    const policy = { ...DEFAULT_RECONNECT_POLICY, initialDelayMs: 100, factor: 2 };
    const run = runTo('connected', { policy });
    const delaysMs = [1_000, 1_000, 4_000, 5_000].map((heldMs) => {
      run.pass(heldMs);
      const delayMs = delayAfter(run.fail());
      run.arrive();
      return delayMs;
    });
    expect(delaysMs).toEqual([200, 400, 800, 100]);
  });

  it('takes up to its share from chance', () => {
    expect(delayAfter(runTo('registering', { chance: 0.5 }).fail({ code: 4008 }))).toBe(425 * 0.75);
  });

  it('starts small again when something tells that the network works', () => {
    const run = runTo('waiting');
    for (let i = 0; i < 5; i++) {
      run.send({ type: 'retry-due' });
      run.fail();
    }
    run.send({ type: 'retry-now' });
    expect(delayAfter(run.fail())).toBe(425);
  });

  it('ends with the attempts that the policy allows', () => {
    const policy = { ...DEFAULT_RECONNECT_POLICY, giveUpAfterAttempts: 2 };
    const run = runTo('waiting', { policy });
    run.send({ type: 'retry-due' });
    expect(run.fail().at(-1)).toMatchObject({
      type: 'announce',
      state: { status: 'closed', error: { reason: 'closed' } },
    });
  });
});

describe('an attempt', () => {
  it('is given up by retry-now when it is older than 1 s, and followed without delay [CL-41]', () => {
    const run = runTo('registering');
    run.pass(-1);
    expect(run.send({ type: 'retry-now' })).toEqual([]);
    expect(run.pass(1).send({ type: 'retry-now' })).toContainEqual({
      type: 'start-retry',
      delayMs: 0,
    });
  });

  it('is not given up when it could make a second client [CL-3]', () => {
    const run = runTo('registering', { isResumable: false });
    expect(run.send({ type: 'retry-now' })).toEqual([]);
    expect(run.send({ type: 'attempt-timeout', attemptTimeoutMs: 2_000 })).toEqual([]);
  });

  it('may take 2 s, and twice as long each time, below the time-out [CL-43]', () => {
    const run = runTo('waiting');
    const attemptTimeoutMs = [1, 2, 3, 4].map(() => {
      const start = run
        .send({ type: 'retry-due' })
        .find((effect) => effect.type === 'start-attempt-timer');
      run.send({ type: 'attempt-timeout', attemptTimeoutMs: start?.attemptTimeoutMs ?? 0 });
      if (start === undefined) run.fail();
      return start?.attemptTimeoutMs;
    });
    expect(attemptTimeoutMs).toEqual([2_000, 4_000, 8_000, undefined]);
    run.send({ type: 'retry-now' });
    run.fail();
    expect(run.send({ type: 'retry-due' })[0]).toMatchObject({ attemptTimeoutMs: 2_000 });
  });

  it('may take as long as its steps once the master has answered [CL-43]', () => {
    const { isAnswered, ...registered } = OURS;
    const effectsOf = (answered: boolean) =>
      types(runTo('registering').send({ ...registered, isAnswered: answered }));
    expect(effectsOf(isAnswered)).toBe('cancel-attempt-timer, open-link');
    expect(effectsOf(false)).toBe('open-link');
  });

  it('freshens services after a link that fell silent, once [CL-43]', () => {
    const run = runTo('connected');
    const reconnect: readonly RunEvent[] = [{ type: 'retry-due' }, OURS, UP];
    run.fail(failure('timeout', 1006, true));
    expect(types(run.send(...reconnect))).toBe('freshen-services, restore');
    run.fail();
    expect(types(run.send(...reconnect))).toBe('restore');
  });

  it('closes its link with the farewell, and leaves one that is up to the caller [EX-55]', () => {
    const farewell = { code: 4000, reason: 'left' };
    const effects = runTo('opening').send({ type: 'close', farewell });
    expect(effects).toContainEqual({ type: 'close-link', farewell });
    expect(types(runTo('connected').send({ type: 'close', farewell }))).not.toContain('link');
  });

  it('knows the id of the last connection, not that of a failed attempt', () => {
    const run = runTo('connected');
    run.fail();
    run.send(
      { type: 'retry-due' },
      { type: 'registered', membership: membershipOf({ clientId: 'client-2' }), isAnswered: true },
    );
    run.fail();
    run.arrive(membershipOf({ clientId: 'client-2' }));
    expect(run.state.announced).toMatchObject({ clientId: 'client-2', resumed: false });
    run.fail();
    run.arrive(membershipOf({ clientId: 'client-2' }));
    expect(run.state.announced).toMatchObject({ resumed: true });
  });

  it('counts attempts since the last connection', () => {
    const run = runTo('waiting');
    expect(run.state.announced).toMatchObject({ attempt: 2, nextAttemptMs: 1_000_425 });
    run.send({ type: 'retry-due' });
    expect(run.state.announced).toMatchObject({ status: 'reconnecting', attempt: 2 });
    run.fail();
    expect(run.state.announced).toMatchObject({ attempt: 3 });
    run.arrive();
    run.fail();
    expect(run.state.announced).toMatchObject({ attempt: 1 });
  });
});
