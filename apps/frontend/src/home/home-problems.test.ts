import {
  SessionState,
  StatusProblemSeverity,
  type Client,
  type Session,
  type StatusProblem,
} from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { homeProblems } from './home-problems.ts';
import { halfRate } from './useProblemActions.ts';

const problem = (changes: Partial<StatusProblem>): StatusProblem => ({
  code: 'client_slow',
  severity: StatusProblemSeverity.WARNING,
  text: 'Mara takes data more slowly than it comes.',
  clientId: 'c',
  sinceMs: 5,
  remedy: 'Let it subscribe to less.',
  sessionId: '',
  moduleId: '',
  ...changes,
});
const session = {
  id: 's',
  name: 'Party',
  processingModules: [],
  extension: {
    state: SessionState.SESSION_DEGRADED,
    problems: [
      { isError: true, code: 'module_failed', message: 'blur was given up.', moduleId: 'm' },
      { isError: false, code: 'cycle', message: 'They feed each other.', moduleId: '' },
    ],
  },
} as unknown as Session;
const list = (problems: StatusProblem[], sessions: Session[] = [], shownAs = 'Mara') =>
  homeProblems(problems, {
    findClient: (id) => (id === 'c' ? ({ name: shownAs } as Client) : undefined),
    ownName: (id) => (id === 'c' ? 'Mara' : undefined),
    sessions,
  });

describe('homeProblems', () => {
  it('tells who, what, what follows, what to do, and where', () => {
    expect(list([problem({})])).toMatchObject([
      {
        subject: 'Mara',
        text: 'takes data more slowly than it comes.',
        remedy: 'Let it subscribe to less.',
        link: { text: 'Open client', to: { path: '/clients/c' } },
        action: undefined,
      },
    ]);
  });

  it.each([
    ['client_silent', {}, { kind: 'show-qr' }, 'Open client'],
    ['publisher_noisy', {}, { kind: 'throttle', clientId: 'c' }, 'Open client'],
    ['client_throttled', {}, { kind: 'unthrottle', clientId: 'c' }, 'Open client'],
    ['master_busy', { clientId: '' }, undefined, 'Open clients'],
    ['module_slow', { sessionId: 's' }, { kind: 'stop-session', sessionId: 's' }, 'Open session'],
    ['machine_busy', { clientId: '' }, undefined, undefined],
    ['limit_reached', {}, undefined, 'Open limits'],
    ['file_broken', { clientId: '' }, undefined, 'Open log'],
  ])('%s %o: what can be done, and where', (code, changes, action, link) => {
    const [one] = list([problem({ code, ...changes })]);
    expect(one?.action).toEqual(action);
    expect(one?.link?.text).toBe(link);
  });

  it('shows the display name of a client in place of the name that it gave itself', () => {
    expect(list([problem({})], [], 'Mara 2')).toMatchObject([
      { subject: 'Mara 2', text: 'takes data more slowly than it comes.' },
    ]);
  });

  it('a sentence about the master keeps the master as its subject', () => {
    const text = 'The master is busy; 80 % is that of Mara.';
    expect(list([problem({ code: 'master_busy', text })])).toMatchObject([
      { subject: undefined, text },
    ]);
  });

  it('sessions tell their own errors, in place of the master', () => {
    const degraded = problem({ code: 'session_degraded', sessionId: 's', clientId: '' });
    expect(list([degraded, problem({})], [session])).toMatchObject([
      { subject: 'Party:', text: 'blur was given up.', isError: true },
      { subject: 'Mara' },
    ]);
  });

  it('each problem has a key of its own that stays', () => {
    const problems = [
      problem({}),
      problem({ clientId: 'd' }),
      problem({ code: 'limit_reached', text: 'The limit topics was met, 3 times so far.' }),
      problem({ code: 'limit_reached', text: 'The limit clients was met, 3 times so far.' }),
    ];
    const keys = list(problems).map(({ key }) => key);
    expect(new Set(keys).size).toBe(4);
    expect(list([problem({ text: 'Mara takes even less.' })])[0]?.key).toBe(keys[0]);
  });
});

it.each([
  [0, 1],
  [3, 1],
  [60, 30],
  [779, 300],
])('of %d records per second, %d are tried', (rate, half) => {
  expect(halfRate(rate)).toBe(half);
});
