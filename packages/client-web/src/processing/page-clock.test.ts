import { clockSuite } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { createPageClock } from './page-clock.ts';
import type { TimerThread } from './page-clock.ts';

function setup({ canStart = true } = {}) {
  const posted: (readonly [number, number?])[] = [];
  let isHidden = true;
  let due: (id: number) => void = () => undefined;
  const clock = createPageClock({
    isHidden: () => isHidden,
    startThread: (): TimerThread => {
      if (!canStart) throw new Error('no workers here');
      return {
        post: (message) => posted.push(message),
        onDue(fn) {
          due = fn;
        },
      };
    },
  });
  return {
    clock,
    posted,
    due: (id: number) => due(id),
    show: () => {
      isHidden = false;
    },
  };
}

clockSuite('the clock of a page that is shown', () => {
  const { clock, show } = setup();
  show();
  return { clock, passTime: () => undefined };
});

describe('the clock of a page', () => {
  it('leaves the time to a thread while the page is hidden', () => {
    const { clock, posted, due } = setup();
    const calls: string[] = [];
    clock.after(20, () => calls.push('a'));
    const cancel = clock.after(30, () => calls.push('b'));
    cancel();
    cancel();
    expect(posted).toEqual([[1, 20], [2, 30], [2]]);
    due(1);
    due(1);
    due(2);
    expect(calls).toEqual(['a']);
  });

  it('continues with each step of an interval, until it is cancelled', () => {
    const { clock, posted, due } = setup();
    let count = 0;
    const cancel = clock.every(10, () => (count += 1));
    due(1);
    due(2);
    expect(count).toBe(2);
    cancel();
    expect(posted.at(-1)).toEqual([3]);
    due(3);
    expect(count).toBe(2);
  });

  it.each([
    ['while the page is shown', { canStart: true, shown: true }],
    ['where there are no workers', { canStart: false, shown: false }],
  ])('keeps the time itself %s', async (_title, { canStart, shown }) => {
    const { clock, posted, show } = setup({ canStart });
    if (shown) show();
    await new Promise<void>((resolve) => clock.after(0, resolve));
    expect(posted).toEqual([]);
  });
});
