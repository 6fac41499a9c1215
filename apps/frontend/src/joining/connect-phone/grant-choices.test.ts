import { AccessRole, type AccessGrant } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { isOpen, leftWord, reusable, usedWords, workWords } from './grant-choices.ts';

const MINUTE = 60_000;
const choice = {
  target: '/topics',
  role: AccessRole.ACCESS_ROLE_VIEWER,
  lifetimeMs: 15 * MINUTE,
  stayMs: 60 * MINUTE,
};
const grant = (changes: Partial<AccessGrant> = {}): AccessGrant =>
  ({
    id: 'g',
    role: choice.role,
    target: choice.target,
    createdMs: 0,
    expiresMs: 15 * MINUTE,
    staysUntilMs: 60 * MINUTE,
    revokedMs: 0,
    maxJoins: 0,
    joins: 0,
    clientIds: [],
    readTopics: [],
    ...changes,
  }) as AccessGrant;

describe('reusable', () => {
  const find = (one: AccessGrant, nowMs = MINUTE, hasSecret = true) =>
    reusable([one], choice, nowMs, () => hasSecret);

  it('finds what was made for the same choice', () => {
    expect(find(grant())?.id).toBe('g');
  });

  it('omits invitations that are for another purpose, expired or about to expire, or without a known code', () => {
    expect(find(grant({ target: '/' }))).toBeUndefined();
    expect(find(grant({ readTopics: ['/party/room'] }))).toBeUndefined();
    expect(find(grant({ role: AccessRole.ACCESS_ROLE_PLAYER }))).toBeUndefined();
    expect(find(grant({ expiresMs: 8 * 60 * MINUTE }))).toBeUndefined();
    expect(find(grant({ staysUntilMs: 15 * MINUTE }))).toBeUndefined();
    expect(find(grant({ revokedMs: 1 }))).toBeUndefined();
    expect(find(grant(), 13 * MINUTE)).toBeUndefined();
    expect(find(grant(), MINUTE, false)).toBeUndefined();
  });
});

it('an invitation is open until its end, its last join or its revocation', () => {
  expect(isOpen(grant(), MINUTE)).toBe(true);
  expect(isOpen(grant(), 15 * MINUTE)).toBe(false);
  expect(isOpen(grant({ maxJoins: 1, joins: 1 }), MINUTE)).toBe(false);
});

it('what is left is told in minutes, hours or days', () => {
  expect(leftWord(30_000)).toBe('1 min');
  expect(leftWord(14.2 * MINUTE)).toBe('15 min');
  expect(leftWord(8 * 60 * MINUTE)).toBe('8 h');
  expect(leftWord(30 * 24 * 60 * MINUTE)).toBe('30 d');
});

it('shows the number of connected clients, else whether it was used', () => {
  expect(usedWords(grant())).toBe('not used yet');
  expect(usedWords(grant({ joins: 1, clientIds: ['a', 'b'] }))).toBe('2 connected');
  expect(usedWords(grant({ joins: 1 }))).toBe('used once');
  expect(usedWords(grant({ joins: 2 }))).toBe('used 2 times');
});

it('what was made is counted in words [AC-90]', () => {
  const words = (work: Partial<AccessGrant>): string =>
    workWords({
      sessionIds: [],
      runningSessionIds: [],
      storedSessionNames: [],
      moduleNames: [],
      ...work,
    } as unknown as AccessGrant);
  expect(words({})).toBe('');
  expect(words({ sessionIds: ['a', 'b'], runningSessionIds: ['a'] })).toBe(
    '2 sessions (1 running)',
  );
  expect(words({ sessionIds: ['a'], storedSessionNames: ['s'], moduleNames: ['m', 'n'] })).toBe(
    '1 session, 1 stored session, 2 modules',
  );
});
