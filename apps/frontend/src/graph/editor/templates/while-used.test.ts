import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { effectScope, onScopeDispose } from 'vue';
import { whileUsed } from './while-used.ts';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

it('is kept from one user to the next, and ended after the last', () => {
  const ended = vi.fn();
  const use = whileUsed(() => {
    onScopeDispose(ended);
    return {};
  });
  const [first, second] = [effectScope(true), effectScope(true)];
  const made = first.run(use);
  first.stop();
  expect(second.run(use)).toBe(made);
  vi.runAllTimers();
  expect(ended).not.toHaveBeenCalled();
  second.stop();
  vi.runAllTimers();
  expect(ended).toHaveBeenCalledOnce();
});
