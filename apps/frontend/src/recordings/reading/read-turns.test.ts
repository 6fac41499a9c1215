import { describe, expect, it } from 'vitest';
import { ReadTurns, type ReadTurn } from './read-turns.ts';

/** A clock on which each step of a read takes a millisecond, and waiting takes its time. */
function setUp() {
  const clock = { nowMs: 0 };
  const turns = new ReadTurns({
    nowMs: () => clock.nowMs,
    pause: () => Promise.resolve(),
    wait: async (ms) => {
      await settle();
      clock.nowMs += ms;
    },
  });
  return { clock, turns };
}

const settle = async (): Promise<void> => {
  for (let i = 0; i < 20; i++) await Promise.resolve();
};

describe('the order of reads', () => {
  it('lets the survey stand still, after its turn, until a seek is done', async () => {
    const { clock, turns } = setUp();
    const order: string[] = [];
    let endSeek = (): void => undefined;
    const survey = turns.run('survey', async (turn: ReadTurn) => {
      for (let step = 0; step < 100; step++) {
        clock.nowMs += 1;
        order.push('survey');
        await turn.next();
      }
    });
    const seek = turns.run('seek', async () => {
      await new Promise<void>((resolve) => (endSeek = resolve));
      order.push('seek');
    });
    await Promise.resolve();
    endSeek();
    await Promise.all([survey, seek]);
    expect(order.indexOf('seek')).toBeLessThanOrEqual(8);
    expect(order.filter((one) => one === 'survey')).toHaveLength(100);
  });

  it('reads a picture after a seek that is under way', async () => {
    const { turns } = setUp();
    const order: string[] = [];
    const seek = turns.run('seek', async () => {
      await settle();
      order.push('seek');
    });
    const frame = turns.run('frame', () => Promise.resolve(order.push('frame')));
    await Promise.all([frame, seek]);
    expect(order).toEqual(['seek', 'frame']);
  });

  it('lets no read wait forever for more urgent ones', async () => {
    const { clock, turns } = setUp();
    void turns.run('seek', () => new Promise<void>(() => undefined));
    let steps = 0;
    await turns.run('survey', async (turn) => {
      for (; steps < 30; steps++) {
        clock.nowMs += 1;
        await turn.next();
      }
    });
    expect(steps).toBe(30);
  });

  it('goes on after a read that failed', async () => {
    const { turns } = setUp();
    await expect(turns.run('seek', () => Promise.reject(new Error('gone')))).rejects.toThrow();
    expect(await turns.run('survey', () => Promise.resolve('read'))).toBe('read');
  });
});
