import { FakeClock } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { TestMaster } from '../src/testing/index.ts';

async function createAda(clock?: FakeClock) {
  const master = new TestMaster(clock === undefined ? {} : { clock });
  const ada = await master.extension('ada');
  const statistics = async (cursor = 0) => {
    const { topicStatistics } = await master.call({
      topic: '/services/ubii/topic_statistics',
      topicStatisticsRequest: { cursor },
    });
    return topicStatistics!;
  };
  const changedSince = async (cursor: number) =>
    (await statistics(cursor)).elements.map(({ topic }) => topic);
  return { master, ada, statistics, changedSince };
}

describe('topic statistics', () => {
  it('count what was published [EX-11]', async () => {
    const { master, ada, statistics } = await createAda();
    await ada.subscribe({ subscribeTopics: ['/a', '/empty'], subscribeTopicRegexp: ['.*'] });
    const startMs = master.clock.nowMs();
    ada.publish('/a', 'double', 1);
    master.clock.advanceSync(100);
    ada.publish('/a', 'vector2', { x: 1, y: 2 });
    const { elements, masterTimeMs, reset, removed } = await statistics();
    const [first, second] = ada
      .takeSent()
      .flatMap((sent) => (sent.kind === 'record' ? [sent] : []));
    expect(elements).toEqual([
      {
        topic: '/a',
        dataFormat: 'vector2',
        publisherId: ada.id,
        records: 2,
        bytes: first!.record.byteLength + second!.record.byteLength,
        dropped: 0,
        publishedMs: startMs + 100,
        subscribers: 1,
        valueBytes: second!.record.byteLength,
      },
      {
        topic: '/empty',
        dataFormat: '',
        publisherId: '',
        records: 0,
        bytes: 0,
        dropped: 0,
        publishedMs: 0,
        subscribers: 1,
        valueBytes: 0,
      },
    ]);
    expect({ masterTimeMs, reset, removed }).toEqual({
      masterTimeMs: startMs + 100,
      reset: true,
      removed: [],
    });
  });

  it('tell what changed since a cursor: records, subscribers, drops [EX-11] [EX-13]', async () => {
    const { master, ada, statistics, changedSince } = await createAda();
    const ben = await master.legacy('ben');
    for (const topic of ['/a', '/b', '/c', '/d']) ada.publish(topic, 'double', 1);
    await ada.subscribe({ subscribeTopics: ['/c'] });
    ada.connection.stall();
    ada.publish('/c', 'double', 2);
    const { cursor } = await statistics();
    expect(await changedSince(cursor)).toEqual([]);
    ada.publish('/a', 'double', 2);
    expect(await changedSince(cursor)).toEqual(['/a']);
    await ben.subscribe({ subscribeTopics: ['/b'] });
    expect(await changedSince(cursor)).toEqual(['/a', '/b']);
    ada.publish('/c', 'double', 3);
    const { elements } = await statistics(cursor);
    expect(elements.map(({ topic, dropped }) => [topic, dropped])).toEqual([
      ['/a', 0],
      ['/b', 0],
      ['/c', 1],
    ]);
  });

  it('tell what is gone, and what only lost its value [EX-11]', async () => {
    const { master, ada, statistics } = await createAda();
    const ben = await master.legacy('ben');
    ben.publish('/gone', 'double', 1);
    ben.publish('/wanted', 'double', 1);
    await ada.subscribe({ subscribeTopics: ['/wanted'] });
    const { cursor } = await statistics();
    await ben.call({ topic: '/services/client/deregistration', client: { id: ben.id } });
    const { removed, elements, reset } = await statistics(cursor);
    expect({ removed, reset }).toEqual({ removed: ['/gone'], reset: false });
    expect(elements).toMatchObject([{ topic: '/wanted', dataFormat: '', valueBytes: 0 }]);
  });

  it('are full for the cursor of another run of the master [EX-12]', async () => {
    const clock = new FakeClock();
    const first = await createAda(clock);
    first.ada.publish('/a', 'double', 1);
    let { cursor } = await first.statistics();
    for (let i = 0; i < 100; i++) ({ cursor } = await first.statistics(cursor));
    clock.advanceSync(1_000);
    const second = await createAda(clock);
    second.ada.publish('/b', 'double', 1);
    const { reset, elements } = await second.statistics(cursor);
    expect(reset).toBe(true);
    expect(elements.map(({ topic }) => topic)).toEqual(['/b']);
  });

  it.each([0, -1, 1.5, Number.NaN, Number.POSITIVE_INFINITY, 2 ** 53])(
    'are full for the cursor %d [EX-12]',
    async (cursor) => {
      const { ada, statistics } = await createAda();
      ada.publish('/a', 'double', 1);
      await statistics();
      expect(await statistics(cursor)).toMatchObject({ reset: true, elements: [{ topic: '/a' }] });
    },
  );

  it('leave out what is under /ubii/ [EX-15]', async () => {
    const { master, ada, statistics } = await createAda();
    await ada.subscribe({ subscribeTopicRegexp: ['^/ubii/'] });
    const { cursor, elements } = await statistics();
    expect(elements).toEqual([]);
    const ben = await master.legacy('ben');
    await ben.call({ topic: '/services/client/deregistration', client: { id: ben.id } });
    expect(await statistics(cursor)).toMatchObject({ elements: [], removed: [] });
  });

  it('make no difference to a record [EX-14]', async () => {
    const { ada, statistics } = await createAda();
    await ada.subscribe({ subscribeTopics: ['/a'] });
    ada.publish('/a', 'double', 1);
    await statistics();
    ada.publish('/a', 'double', 2);
    expect(ada.takeValues()).toEqual([
      ['/a', 1],
      ['/a', 2],
    ]);
  });
});
