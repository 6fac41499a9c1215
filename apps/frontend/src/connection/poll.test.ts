import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { effectScope, nextTick, ref } from 'vue';
import { createInterest } from './interest.ts';
import { usePoll } from './poll.ts';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

function setup(enabled = true) {
  const isOn = ref(enabled);
  const intervalMs = ref(1000);
  const answers: (() => void)[] = [];
  const ask = vi.fn(() => new Promise<void>((resolve) => answers.push(resolve)));
  const scope = effectScope();
  scope.run(() => usePoll(ask, intervalMs, isOn));
  const answer = async (): Promise<void> => {
    answers.shift()?.();
    await vi.advanceTimersByTimeAsync(0);
  };
  return { isOn, intervalMs, ask, answer, scope };
}

describe('usePoll', () => {
  it('asks at once, and again an interval after the answer', async () => {
    const { ask, answer } = setup();
    expect(ask).toHaveBeenCalledTimes(1);
    await vi.advanceTimersByTimeAsync(5000);
    expect(ask).toHaveBeenCalledTimes(1);
    await answer();
    await vi.advanceTimersByTimeAsync(999);
    expect(ask).toHaveBeenCalledTimes(1);
    await vi.advanceTimersByTimeAsync(1);
    expect(ask).toHaveBeenCalledTimes(2);
  });

  it('rests while it is not wanted, and asks at once when it is', async () => {
    const { ask, isOn } = setup(false);
    await vi.advanceTimersByTimeAsync(5000);
    expect(ask).not.toHaveBeenCalled();
    isOn.value = true;
    await nextTick();
    expect(ask).toHaveBeenCalledTimes(1);
  });

  it('a shorter interval counts at once', async () => {
    const { ask, answer, intervalMs } = setup();
    await answer();
    intervalMs.value = 100;
    await nextTick();
    expect(ask).toHaveBeenCalledTimes(2);
  });

  it('ends with its scope', async () => {
    const { ask, answer, scope } = setup();
    await answer();
    scope.stop();
    await vi.advanceTimersByTimeAsync(5000);
    expect(ask).toHaveBeenCalledTimes(1);
  });
});

it('interest is the shortest interval anyone wants, as long as they live', () => {
  const interest = createInterest();
  const slow = effectScope();
  const quick = effectScope();
  expect(interest.intervalMs.value).toBeUndefined();
  slow.run(() => interest.express(2000));
  quick.run(() => interest.express(250));
  expect(interest.intervalMs.value).toBe(250);
  quick.stop();
  expect(interest.intervalMs.value).toBe(2000);
  slow.stop();
  expect(interest.intervalMs.value).toBeUndefined();
});
