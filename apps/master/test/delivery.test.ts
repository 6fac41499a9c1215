import { encodeRecord } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TestMaster, type TestMasterOptions } from '../src/testing/index.ts';

async function createPair(options: TestMasterOptions = {}) {
  const master = new TestMaster(options);
  const ada = await master.legacy('ada');
  const ben = await master.extension('ben');
  await ben.subscribe({ subscribeTopics: ['/a', '/b', '/key'] });
  ben.takeSent();
  const keyEvent = (key: string) => ({ type: 1 as const, key });
  const status = async () => {
    const reply = await master.call({
      topic: '/services/ubii/master_status',
      masterStatusRequest: {},
    });
    return reply.masterStatus!;
  };
  return { master, ada, ben, keyEvent, status };
}

describe('delivery', () => {
  it('puts what meets in one turn into one write [TD-30]', async () => {
    const { master, ada, ben } = await createPair();
    ada.send('/a', 'double', 1);
    ada.send('/b', 'double', 2);
    ada.send('/a', 'double', 3);
    expect(ben.connection.sent).toEqual([]);
    master.clock.endTurnSync();
    expect(ben.connection.batches.splice(0)).toHaveLength(1);
    ada.publish('/a', 'double', 4);
    expect(ben.connection.batches).toHaveLength(1);
    expect(ben.takeValues()).toHaveLength(4);
  });

  it('gives the same batch to all subscribers of the same records [TD-30]', async () => {
    const { master, ada, ben } = await createPair();
    const cleo = await master.legacy('cleo');
    await cleo.subscribe({ subscribeTopicRegexp: ['^/[ab]$'] });
    ada.send('/a', 'double', 1);
    ada.send('/b', 'double', 2);
    master.clock.endTurnSync();
    expect(cleo.connection.batches[0]).toBe(ben.connection.batches[0]);
  });

  it('ends a write with the record that fills it [TD-30]', async () => {
    const { master, ada, ben } = await createPair({ limits: { batchBytes: 100 } });
    const record = encodeRecord({ topic: '/a', format: 'string', value: 'x'.repeat(40) });
    ada.sendRecords(...Array.from({ length: 5 }, () => record));
    master.clock.endTurnSync();
    expect(ben.connection.batches.map((batch) => batch.records.length)).toEqual([3, 2]);
    ada.publish('/a', 'double', 1);
    expect(ben.connection.batches).toHaveLength(3);
  });

  it('keeps the newest of a state for a socket that takes nothing [TD-31]', async () => {
    const { ada, ben } = await createPair();
    ben.connection.stall();
    for (let i = 0; i < 1000; i++) ada.publish('/a', 'double', i);
    ada.publish('/b', 'double', -1);
    expect(ben.connection.sent).toEqual([]);
    ben.connection.take();
    ben.socket.handleDrain();
    expect(ben.takeValues()).toEqual([
      ['/a', 999],
      ['/b', -1],
    ]);
    ada.publish('/a', 'double', 1000);
    expect(ben.takeValues()).toEqual([['/a', 1000]]);
  });

  it('keeps one picture for each slow viewer, the newest, and lets its publisher go on [TD-31] [TD-32]', async () => {
    const { master, ada, ben } = await createPair();
    const fast = await master.extension('fast');
    const topic = '/camera';
    for (const viewer of [ben, fast]) await viewer.subscribe({ subscribeTopics: [topic] });
    const picture = (number: number) => ({
      width: 250,
      height: 400,
      dataFormat: 0 as const,
      data: new Uint8Array(100_000).fill(number),
    });
    const numbers = (viewer: typeof ben) =>
      viewer.takeValues().map(([, value]) => (value as { data: Uint8Array }).data[0]);
    const queued = async () => {
      const { clientReport } = await master.call({
        topic: '/services/ubii/client_report',
        clientReportRequest: { clientIds: [ben.id] },
      });
      const { queuedRecords, dropped } = clientReport!.clients[0]!;
      return { queuedRecords, dropped };
    };
    ben.connection.stall();
    for (let i = 0; i < 200; i++) {
      ada.publish(topic, 'image2D', picture(i));
      expect((await queued()).queuedRecords).toBeLessThanOrEqual(1);
    }
    expect(numbers(fast)).toHaveLength(200);
    expect(ada.takeErrors()).toEqual([]);
    expect(await queued()).toEqual({ queuedRecords: 1, dropped: 199 });
    ben.connection.take();
    ben.socket.handleDrain();
    expect(numbers(ben)).toEqual([199]);
    // Back after a pause, it gets the newest one alone.
    ben.drop();
    for (let i = 200; i < 250; i++) ada.publish(topic, 'image2D', picture(i));
    ben.open();
    expect(numbers(ben)).toEqual([249]);
  });

  it('keeps every event for a socket that takes nothing [TD-31]', async () => {
    const { ada, ben, keyEvent } = await createPair();
    ben.connection.stall();
    const keys = Array.from({ length: 100 }, (_, i) => `key ${i}`);
    for (const key of keys) ada.publish('/key', 'keyEvent', keyEvent(key));
    ben.connection.take();
    ben.socket.handleDrain();
    expect(ben.takeValues().map(([, value]) => (value as { key: string }).key)).toEqual(keys);
  });

  it('bounds the events that wait, and drops the oldest [TD-31]', async () => {
    const { ada, ben, keyEvent, status } = await createPair({
      limits: { queuedEventsPerTopic: 10 },
    });
    ben.connection.stall();
    for (let i = 0; i < 25; i++) ada.publish('/key', 'keyEvent', keyEvent(String(i)));
    ben.connection.take();
    ben.socket.handleDrain();
    expect(ben.takeValues().map(([, value]) => (value as { key: string }).key)).toEqual(
      Array.from({ length: 10 }, (_, i) => String(i + 15)),
    );
    expect((await status()).dropped).toBe(15);
  });

  it('begins to wait only beyond what a socket may have queued [TD-31]', async () => {
    const { ada, ben } = await createPair({ limits: { connectionQueuedBytes: 1000 } });
    ben.connection.stall(999);
    ada.publish('/a', 'double', 1);
    expect(ben.takeValues()).toEqual([['/a', 1]]);
    ada.publish('/a', 'double', 2);
    expect(ben.takeValues()).toEqual([]);
    ben.connection.take(500);
    ada.publish('/b', 'double', 3);
    expect(ben.takeValues()).toEqual([
      ['/a', 2],
      ['/b', 3],
    ]);
  });

  it('lets fewer bytes of pictures lie in a socket than of other records [TD-35]', async () => {
    const { ada, ben } = await createPair();
    const large = 'x'.repeat(100_000);
    ben.connection.stall(300_000);
    ada.publish('/a', 'string', large);
    expect(ben.takeValues()).toEqual([]);
    ben.connection.take();
    ben.socket.handleDrain();
    expect(ben.takeValues()).toHaveLength(1);
    ben.connection.stall(300_000);
    ada.publish('/b', 'double', 1);
    expect(ben.takeValues()).toEqual([['/b', 1]]);
  });

  it('bounds the bytes that wait [TD-32]', async () => {
    const { ada, ben, status } = await createPair({ limits: { queueBytes: 1000 } });
    ben.connection.stall();
    ada.publish('/a', 'string', 'a'.repeat(600));
    ada.publish('/b', 'string', 'b'.repeat(600));
    ben.connection.take();
    ben.socket.handleDrain();
    expect(ben.takeValues().map(([topic]) => topic)).toEqual(['/b']);
    expect((await status()).dropped).toBe(1);
  });

  it('closes a socket that takes nothing for 30 s [TD-32]', async () => {
    const { master, ada, ben } = await createPair();
    ben.connection.stall();
    for (let i = 0; i < 65; i++) {
      ada.publish('/a', 'double', i);
      master.clock.advanceSync(500);
      if (ben.closed === undefined) ben.sendText('PONG');
    }
    expect(ben.closed).toEqual({ reason: 'too slow' });
    expect(ada.closed).toBeUndefined();
    ben.open();
    expect(ben.takeValues()).toEqual([['/a', 64]]);
  });

  it('bears a socket that takes little [TD-32]', async () => {
    const { master, ada, ben } = await createPair();
    ben.connection.stall();
    for (let i = 0; i < 200; i++) {
      ada.publish('/a', 'double', i);
      ben.connection.take(1);
      master.clock.advanceSync(500);
      ben.sendText('PONG');
    }
    expect(ben.closed).toBeUndefined();
  });

  it('checks a queue by itself when the socket does not report that it has drained [TD-31]', async () => {
    const { master, ada, ben } = await createPair();
    ben.connection.stall();
    ada.publish('/a', 'double', 1);
    ben.connection.take();
    master.clock.advanceSync(500);
    expect(ben.takeValues()).toEqual([['/a', 1]]);
  });

  it('queues nothing for a client without socket, but sends what it missed [TD-33]', async () => {
    const { ada, ben } = await createPair();
    ada.publish('/b', 'double', 0);
    ben.takeSent();
    ben.sendText('PONG');
    ben.drop();
    for (let i = 0; i < 100; i++) ada.publish('/a', 'double', i);
    ben.open();
    expect(ben.takeValues()).toEqual([['/a', 99]]);
  });

  it('sends again what a dead socket was given after the last word of the client [TD-33]', async () => {
    const { ada, ben } = await createPair();
    ben.sendText('PONG');
    ada.publish('/a', 'double', 1);
    expect(ben.takeValues()).toEqual([['/a', 1]]);
    // The network failed unnoticed: the client reconnects over another one.
    ben.open();
    expect(ben.takeValues()).toEqual([['/a', 1]]);
    ben.sendText('PONG');
    ben.open();
    expect(ben.takeValues()).toEqual([]);
  });

  it('sends what was missed by pattern to extension clients only [TD-33]', async () => {
    const { master, ada, ben } = await createPair();
    const cleo = await master.legacy('cleo');
    for (const client of [ben, cleo]) await client.subscribe({ subscribeTopicRegexp: ['^/p'] });
    ben.drop();
    cleo.drop();
    ada.publish('/p', 'double', 1);
    ben.open();
    cleo.open();
    expect(ben.takeValues()).toEqual([['/p', 1]]);
    expect(cleo.takeValues()).toEqual([]);
  });

  it('shows what was dropped, for the client and for the topic [TD-34]', async () => {
    const { master, ada, ben, status } = await createPair();
    ben.connection.stall();
    for (let i = 0; i < 11; i++) ada.publish('/a', 'double', i);
    const { dropped, problems } = await status();
    expect(dropped).toBe(10);
    expect(problems).toMatchObject([{ code: 'client_slow', clientId: ben.id }]);
    expect(problems[0]?.text).toMatch(/^ben .* 10 queued records/);
    const { topicStatistics } = await master.call({
      topic: '/services/ubii/topic_statistics',
      topicStatisticsRequest: {},
    });
    const { elements } = topicStatistics!;
    expect(elements.find(({ topic }) => topic === '/a')).toMatchObject({ dropped: 10 });
  });
});
