import { describe, expect, it } from 'vitest';
import { FakeClock } from './testing/index.ts';
import { within } from './within.ts';

function setup() {
  const clock = new FakeClock();
  let finish = (): void => undefined;
  let fail = (_reason: Error): void => undefined;
  const work = new Promise<void>((resolve, reject) => {
    finish = resolve;
    fail = reject;
  });
  return { clock, waiting: within(clock, 100, work), finish, fail };
}

describe('within', () => {
  it('returns true for work that ends in time, and leaves no timer', async () => {
    const { clock, waiting, finish } = setup();
    await clock.advance(99);
    finish();
    expect(await waiting).toBe(true);
    expect(clock.timerCount).toBe(0);
  });

  it('returns false when the time is over, and ignores a later failure', async () => {
    const { clock, waiting, fail } = setup();
    await clock.advance(100);
    expect(await waiting).toBe(false);
    fail(new Error('too late'));
    await clock.advance(0);
  });

  it('rejects with what the work rejects with, and leaves no timer', async () => {
    const { clock, waiting, fail } = setup();
    fail(new Error('broken'));
    await expect(waiting).rejects.toThrow('broken');
    expect(clock.timerCount).toBe(0);
  });
});
