import { describe, expect, it } from 'vitest';
import { DEFAULT_LIMITS } from '../src/index.ts';
import { TestMaster } from '../src/testing/index.ts';

async function read(master: TestMaster) {
  const { limitList } = await master.call({ topic: '/services/ubii/limit_list' });
  return limitList!.elements;
}

describe('the list of limits', () => {
  it('has every limit in force, with unit and reason [EX-35]', async () => {
    const limits = await read(new TestMaster({ limits: { clients: 3 } }));
    expect(limits.map(({ name }) => name).sort()).toEqual(Object.keys(DEFAULT_LIMITS).sort());
    expect(limits.find(({ name }) => name === 'clients')?.value).toBe(3);
    for (const { name, unit, reason, group } of limits) {
      expect([name, unit, group].every((text) => text !== '')).toBe(true);
      expect(reason).toMatch(/^[A-Z].*\.$/);
    }
  });

  it('is sorted by group [EX-35]', async () => {
    const groups = (await read(new TestMaster())).map(({ group }) => group);
    const changes = groups.filter((group, index) => group !== groups[index - 1]);
    expect(changes).toEqual([...new Set(groups)]);
    expect(changes[0]).toBe('messages');
  });

  it('counts the clients that reached a limit [EX-35]', async () => {
    const master = new TestMaster({ limits: { topicBytes: 3 } });
    const ada = await master.extension('ada');
    ada.publish('/abc', 'double', 1);
    const limits = await read(master);
    expect(limits.find(({ name }) => name === 'topicBytes')?.hits).toBe(1);
  });

  it('reports the use, and the client with the highest use [EX-36]', async () => {
    const master = new TestMaster();
    const ada = await master.extension('ada');
    const ben = await master.extension('ben');
    await ada.subscribe({ subscribeTopicRegexp: ['^/a', '^/b'] });
    ada.publish('/a', 'double', 1);
    for (let i = 0; i < 7; i++) ben.publish('/b', 'double', i);
    ben.publish('/c', 'double', 1);
    master.clock.advanceSync(1_000);
    const uses = Object.fromEntries((await read(master)).map(({ name, use }) => [name, use]));
    expect(uses).toMatchObject({
      clients: { value: 2, clientId: '' },
      sockets: { value: 2 },
      patterns: { value: 2 },
      patternsPerClient: { value: 2, clientId: ada.id },
      topicsPerClient: { value: 2, clientId: ben.id },
      recordsPerSecond: { value: 8, clientId: ben.id },
      sessions: { value: 0 },
      sessionBytes: { value: 0, sessionId: '' },
    });
    expect(uses['frameBytes']).toBeUndefined();
  });
});
