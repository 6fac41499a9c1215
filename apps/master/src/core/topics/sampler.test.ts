import { describe, expect, it } from 'vitest';
import { TestMaster } from '../../testing/index.ts';

async function createPair(maxRateHz: number) {
  const master = new TestMaster();
  const ada = await master.legacy('ada');
  const ben = await master.legacy('ben');
  await ben.subscribe({ subscribeTopics: ['/a', '/b'], maxRateHz });
  // Advance in small steps, so that no client is removed for being silent.
  const advance = (durationMs: number): void => {
    for (let rest = durationMs; rest > 0; rest -= 1000) {
      master.clock.advanceSync(Math.min(rest, 1000));
      ada.sendText('PONG');
      ben.sendText('PONG');
    }
  };
  return { master, ada, ben, advance };
}

describe('sampled subscriptions', () => {
  it('deliver the first record at once and then the newest, so often at most [TD-28] [EX-8]', async () => {
    const { ada, ben, advance } = await createPair(10);
    for (let i = 0; i < 25; i++) {
      ada.publish('/a', 'double', i);
      advance(10);
    }
    expect(ben.takeValues()).toEqual([
      ['/a', 0],
      ['/a', 9],
      ['/a', 19],
    ]);
  });

  it('never withhold the newest record permanently [TD-28]', async () => {
    const { ada, ben, advance } = await createPair(10);
    ada.publish('/a', 'double', 1);
    ada.publish('/a', 'double', 2);
    ada.publish('/a', 'double', 3);
    expect(ben.takeValues()).toEqual([['/a', 1]]);
    advance(99);
    expect(ben.takeValues()).toEqual([]);
    advance(1);
    expect(ben.takeValues()).toEqual([['/a', 3]]);
    advance(1000);
    expect(ben.takeValues()).toEqual([]);
  });

  it('count each topic on its own, and deliver topics of one rate at the same moments [TD-28]', async () => {
    const { ada, ben, advance } = await createPair(10);
    ada.publish('/a', 'double', 1);
    advance(50);
    ada.publish('/b', 'double', 2);
    ada.publish('/a', 'double', 3);
    ada.publish('/b', 'double', 4);
    expect(ben.takeValues()).toEqual([
      ['/a', 1],
      ['/b', 2],
    ]);
    advance(49);
    expect(ben.takeValues()).toEqual([]);
    advance(1);
    expect(ben.takeValues()).toEqual([
      ['/a', 3],
      ['/b', 4],
    ]);
  });

  it('keep their rate when ticks do not fall on whole milliseconds [TD-28]', async () => {
    const { ada, ben, advance } = await createPair(60);
    for (let i = 0; i < 1000; i++) {
      ada.publish('/a', 'double', i);
      advance(1);
    }
    expect([59, 60, 61]).toContain(ben.takeValues().length);
  });

  it('wait as long as it takes when the rate is tiny [TD-28]', async () => {
    const { ada, ben, advance } = await createPair(1 / 300);
    ada.publish('/a', 'double', 1);
    ada.publish('/a', 'double', 2);
    advance(299_000);
    expect(ben.takeValues()).toEqual([['/a', 1]]);
    advance(1_000);
    expect(ben.takeValues()).toEqual([['/a', 2]]);
  });

  it('let the fastest of several subscriptions count [TD-28]', async () => {
    const { ada, ben, advance } = await createPair(1);
    await ben.subscribe({ subscribeTopicRegexp: ['^/a'], maxRateHz: 10 });
    ada.publish('/a', 'double', 1);
    ada.publish('/a', 'double', 2);
    advance(100);
    expect(ben.takeValues()).toEqual([
      ['/a', 1],
      ['/a', 2],
    ]);
    await ben.subscribe({ subscribeTopicRegexp: ['/a$'] });
    ada.publish('/a', 'double', 3);
    ada.publish('/a', 'double', 4);
    expect(ben.takeValues()).toEqual([
      ['/a', 3],
      ['/a', 4],
    ]);
  });

  it('give what they hold back before the first record of a faster subscription [TD-15]', async () => {
    const { ada, ben } = await createPair(1);
    ada.publish('/a', 'double', 1);
    ada.publish('/a', 'double', 2);
    await ben.subscribe({ subscribeTopics: ['/a'] });
    ada.publish('/a', 'double', 3);
    expect(ben.takeValues()).toEqual([
      ['/a', 1],
      ['/a', 2],
      ['/a', 3],
    ]);
  });

  it('deliver nothing after they were ended', async () => {
    const { ada, ben, advance } = await createPair(10);
    ada.publish('/a', 'double', 1);
    ada.publish('/a', 'double', 2);
    ben.takeSent();
    await ben.subscribe({ unsubscribeTopics: ['/a'] });
    advance(1000);
    expect(ben.takeValues()).toEqual([]);
  });

  it('queue the record they held back when the socket closed [TD-33]', async () => {
    const { ada, ben, advance } = await createPair(10);
    ada.publish('/a', 'double', 1);
    ada.publish('/a', 'double', 2);
    ben.drop();
    advance(1000);
    ben.open();
    expect(ben.takeValues()).toEqual([['/a', 2]]);
  });

  it.each([-1, Number.NaN, Number.NEGATIVE_INFINITY])('refuse the rate %d', async (maxRateHz) => {
    const { ben } = await createPair(10);
    await expect(ben.subscribe({ subscribeTopics: ['/c'], maxRateHz })).rejects.toThrow(
      /^invalid_argument: .*max_rate_hz/,
    );
  });
});
