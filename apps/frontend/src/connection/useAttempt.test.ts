import { ConnectionError } from '@ubii/client-web';
import { ServiceError } from '@ubii/proto';
import { describe, expect, it, vi } from 'vitest';
import { refusalSentence, tryRequest, useAttempt, useAttemptByKey } from './useAttempt.ts';

const refused = (): Promise<never> =>
  Promise.reject(new ServiceError('permission_denied', 'Viewers cannot start sessions.'));
const unreachable = (): Promise<never> =>
  Promise.reject(new ConnectionError('closed', 'The connection was lost'));
const broken = (): Promise<never> => Promise.reject(new TypeError('x is not a function'));

function openPromise(): { readonly promise: Promise<void>; resolve(): void } {
  let resolve = (): void => undefined;
  const promise = new Promise<void>((ready) => (resolve = ready));
  return { promise, resolve: () => resolve() };
}

describe('tryRequest', () => {
  it('returns the result', async () => {
    expect(await tryRequest(async () => 7)).toBe(7);
  });

  it('hands on why the master refused, or is not reachable', async () => {
    const onError = vi.fn();
    expect(await tryRequest(refused, onError)).toBeUndefined();
    expect(await tryRequest(unreachable, onError)).toBeUndefined();
    expect(onError.mock.calls.map(([{ message }]) => message)).toEqual([
      'Viewers cannot start sessions.',
      'The connection was lost',
    ]);
  });

  it('throws errors of the program', async () => {
    await expect(tryRequest(broken)).rejects.toThrow('x is not a function');
  });
});

describe('useAttempt', () => {
  it('keeps the sentence of a refusal until the next request', async () => {
    const { problem, attempt } = useAttempt();
    expect(await attempt(refused)).toBeUndefined();
    expect(problem.value).toBe('Viewers cannot start sessions.');
    const next = attempt(async () => 7);
    expect(problem.value).toBeUndefined();
    expect(await next).toBe(7);
  });

  it('is busy until all its requests have ended', async () => {
    const { isBusy, attempt } = useAttempt();
    const first = openPromise();
    const second = openPromise();
    const both = [attempt(() => first.promise), attempt(() => second.promise)];
    first.resolve();
    await both[0];
    expect(isBusy.value).toBe(true);
    second.resolve();
    await both[1];
    expect(isBusy.value).toBe(false);
  });

  it('keeps the sentence of requests that repeat until one succeeds', async () => {
    const { problem, attempt } = useAttempt({ sentenceOf: refusalSentence, keepsProblem: true });
    await attempt(refused);
    const next = attempt(unreachable);
    expect(problem.value).toBe('Viewers cannot start sessions.');
    await next;
    expect(problem.value).toBe('Viewers cannot start sessions.');
    await attempt(async () => 7);
    expect(problem.value).toBeUndefined();
  });

  it('throws errors of the program, unless its work also loads code', async () => {
    const { problem, isBusy, attempt } = useAttempt();
    await expect(attempt(broken)).rejects.toThrow('x is not a function');
    expect([problem.value, isBusy.value]).toEqual([undefined, false]);
    const all = useAttempt({ catchesAll: true });
    await all.attempt(broken);
    expect(all.problem.value).toBe('x is not a function');
  });
});

describe('useAttemptByKey', () => {
  it('keeps problems apart, and which things have a pending request', async () => {
    const { problems, busy, attempt, dismiss } = useAttemptByKey();
    const pending = openPromise();
    const own = attempt('a', () => pending.promise);
    await attempt('b', refused);
    expect([...busy.value]).toEqual(['a']);
    expect([...problems.value]).toEqual([['b', 'Viewers cannot start sessions.']]);
    pending.resolve();
    await own;
    dismiss('b');
    expect([busy.value.size, problems.value.size]).toEqual([0, 0]);
  });
});
