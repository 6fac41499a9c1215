import { FakeClock } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { RateLimit } from './local-subscription.ts';

function setup(maxRateHz = 10) {
  const clock = new FakeClock();
  const delivered: string[] = [];
  const limit = new RateLimit<{ topic: string; n: number }>(clock, maxRateHz, ({ topic, n }) =>
    delivered.push(`${topic}${n}`),
  );
  return { clock, delivered, limit };
}

describe('RateLimit [TD-28]', () => {
  it('lets the first record of a topic through at once', () => {
    const { limit, delivered } = setup();
    limit.handle({ topic: 'a', n: 1 });
    limit.handle({ topic: 'b', n: 1 });
    expect(delivered).toEqual(['a1', 'b1']);
  });

  it('delivers the newest of those that came too early, once the interval is over', async () => {
    const { limit, delivered, clock } = setup(10);
    for (const n of [1, 2, 3]) limit.handle({ topic: 'a', n });
    await clock.advance(99);
    expect(delivered).toEqual(['a1']);
    await clock.advance(1);
    expect(delivered).toEqual(['a1', 'a3']);
  });

  it('keeps the rate after a late delivery', async () => {
    const { limit, delivered, clock } = setup(10);
    limit.handle({ topic: 'a', n: 1 });
    limit.handle({ topic: 'a', n: 2 });
    await clock.advance(100);
    limit.handle({ topic: 'a', n: 3 });
    expect(delivered).toEqual(['a1', 'a2']);
    await clock.advance(100);
    expect(delivered).toEqual(['a1', 'a2', 'a3']);
  });

  it('forgets a topic on which nothing happens', async () => {
    const { limit, clock } = setup(10);
    limit.handle({ topic: 'a', n: 1 });
    await clock.advance(100);
    expect(clock.timerCount).toBe(0);
  });

  it('delivers nothing after close()', async () => {
    const { limit, delivered, clock } = setup();
    limit.handle({ topic: 'a', n: 1 });
    limit.handle({ topic: 'a', n: 2 });
    limit.close();
    await clock.advance(1_000);
    expect(delivered).toEqual(['a1']);
    expect(clock.timerCount).toBe(0);
  });

  it.each([0, -1, Number.NaN])('refuses a rate of %s Hz', (rate) => {
    expect(() => setup(rate)).toThrow(RangeError);
  });
});
