import { encode, encodeRecord } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { emptyRecord, frameOf, TestMaster } from '../src/testing/index.ts';

async function createPair() {
  const master = new TestMaster();
  const ada = await master.legacy('ada');
  const ben = await master.legacy('ben');
  return { master, ada, ben };
}

describe('publishing', () => {
  it('handles a list record by record, in order [TD-10] [TD-15]', async () => {
    const { ada, ben, master } = await createPair();
    await ben.subscribe({ subscribeTopics: ['/a', '/b'] });
    ada.sendRecords(
      encodeRecord({ topic: '/a', format: 'double', value: 1 }),
      encodeRecord({ topic: '/b', format: 'double', value: 2 }),
      encodeRecord({ topic: '/a', format: 'double', value: 3 }),
    );
    master.clock.endTurnSync();
    expect(ben.takeValues()).toEqual([
      ['/a', 1],
      ['/b', 2],
      ['/a', 3],
    ]);
  });

  it('forwards and retains the bytes as they came [TD-11] [EC-17]', async () => {
    const { ada, ben, master } = await createPair();
    await ben.subscribe({ subscribeTopics: ['/a'] });
    // Members out of order, an explicit zero, an unknown field: encoding would change these bytes.
    const record = Uint8Array.of(
      ...[0x32, 0x09, 0x09, 0, 0, 0, 0, 0, 0, 0, 0],
      ...[0xf8, 0x3f, 0x07],
      ...[0x0a, 0x02, 0x2f, 0x61],
    );
    ada.sendRecords(record);
    master.clock.endTurnSync();
    expect(ben.takeSent()).toEqual([{ kind: 'record', record }]);
    const cleo = await master.legacy('cleo');
    await cleo.subscribe({ subscribeTopics: ['/a'] });
    expect(cleo.takeSent()).toEqual([{ kind: 'record', record }]);
  });

  it('takes records out of whatever memory they come in [TD-11]', async () => {
    const { ada, ben, master } = await createPair();
    await ben.subscribe({ subscribeTopics: ['/a'] });
    const frame = frameOf([encodeRecord({ topic: '/a', format: 'string', value: 'mine' })]);
    const pooled = Buffer.alloc(8192, 0xff);
    pooled.set(frame, 1000);
    for (const bytes of [frame, Buffer.from(frame), pooled.subarray(1000, 1000 + frame.length)]) {
      ada.socket.handleTopicData(bytes);
      master.clock.endTurnSync();
      expect(ben.takeValues()).toEqual([['/a', 'mine']]);
    }
  });

  it('refuses a frame from the first broken record on [TD-12]', async () => {
    const { ada, ben, master } = await createPair();
    await ben.subscribe({ subscribeTopics: ['/a', '/b', '/c'] });
    const broken = encode('ubii.topicData.TopicDataRecord', { topic: '/b', vector2: { x: 1 } });
    broken[broken.length - 9] = 0x0d;
    ada.sendRecords(
      encodeRecord({ topic: '/a', format: 'double', value: 1 }),
      broken,
      encodeRecord({ topic: '/c', format: 'double', value: 3 }),
    );
    master.clock.endTurnSync();
    expect(ben.takeValues()).toEqual([['/a', 1]]);
    expect(ada.takeErrors()).toMatchObject([{ code: 'invalid_argument', stack: '' }]);
  });

  it('takes a record without value [TD-13]', async () => {
    const { ada, ben, master } = await createPair();
    await ben.subscribe({ subscribeTopics: ['/a'] });
    ada.sendRecords(emptyRecord('/a'));
    master.clock.endTurnSync();
    expect(ben.takeRecords()).toMatchObject([{ topic: '/a', value: undefined }]);
    const { stringList } = await master.call({ topic: '/services/topic_list' });
    expect(stringList?.elements).toContain('/a');
  });

  it.each([
    ['', 'invalid_argument'],
    ['/a\n', 'invalid_argument'],
    ['/\u0000', 'invalid_argument'],
    ['/' + 'a'.repeat(1024), 'resource_exhausted'],
  ])('refuses the topic %.20j [TD-13]', async (topic, code) => {
    const { ada, ben, master } = await createPair();
    await ben.subscribe({ subscribeTopicRegexp: ['.*'] });
    ada.sendRecords(encode('ubii.topicData.TopicDataRecord', { topic, double: 1 }));
    master.clock.endTurnSync();
    expect(ada.takeErrors()).toMatchObject([{ code }]);
    expect(ben.takeSent()).toEqual([]);
  });

  it('accepts any other topic, and delivers it to its subscribers [TD-13]', async () => {
    const { ada, ben } = await createPair();
    const topics = ['a', 'with space', '/ä/🙂', '//', 'services/x', '/'.padEnd(1024, 'a')];
    await ben.subscribe({ subscribeTopics: topics });
    for (const topic of topics) ada.publish(topic, 'bool', false);
    expect(ben.takeValues()).toEqual(topics.map((topic) => [topic, false]));
  });

  it('reaches a client once, the publisher too, however many subscriptions match [TD-14]', async () => {
    const { ada, ben } = await createPair();
    await ada.subscribe({ subscribeTopics: ['/a'] });
    await ben.subscribe({ subscribeTopics: ['/a'], subscribeTopicRegexp: ['^/a', 'a$', '.*'] });
    ada.publish('/a', 'double', 1);
    expect(ada.takeValues()).toEqual([['/a', 1]]);
    expect(ben.takeValues()).toEqual([['/a', 1]]);
  });

  it('replaces the value that is retained [TD-14]', async () => {
    const { ada, ben } = await createPair();
    ada.publish('/a', 'double', 1);
    ada.publish('/a', 'string', 'two');
    await ben.subscribe({ subscribeTopics: ['/a'] });
    expect(ben.takeValues()).toEqual([['/a', 'two']]);
  });

  it.each(['/info/session/start', '/info/x', 'info/device/new', '/ubii/client/x', 'ubii/x'])(
    'refuses %s, which is the master’s [TD-16] [TD-17]',
    async (topic) => {
      const { ada, ben } = await createPair();
      await ben.subscribe({ subscribeTopics: [topic] });
      ben.takeSent();
      ada.publish(topic, 'string', 'mine');
      ada.publish(topic, 'string', 'mine');
      const errors = ada.takeErrors();
      expect(errors).toMatchObject([{ code: 'permission_denied' }, { code: 'permission_denied' }]);
      expect(errors[0]?.message).toContain(topic);
      expect(ben.takeValues()).toEqual([]);
    },
  );

  it('takes topics that only look like the master’s [TD-16]', async () => {
    const { ada, ben } = await createPair();
    const topics = ['/information', '/ubiii/x', '/a/info/b', '/info'];
    await ben.subscribe({ subscribeTopics: topics });
    for (const topic of topics) ada.publish(topic, 'bool', true);
    expect(ben.takeValues()).toHaveLength(topics.length);
  });

  it('tells of ten refusals in a second, and counts all [TD-17]', async () => {
    const { ada, master } = await createPair();
    for (let i = 0; i < 100; i++) ada.send('/info/x', 'double', i);
    expect(ada.takeErrors()).toHaveLength(10);
    const { masterStatus } = await master.call({
      topic: '/services/ubii/master_status',
      masterStatusRequest: {},
    });
    expect(masterStatus?.refused).toBe(100);
    expect(masterStatus?.recordsIn).toBe(0);
    master.clock.advanceSync(1_000);
    ada.takeSent();
    for (let i = 0; i < 100; i++) ada.send('/info/x', 'double', i);
    expect(ada.takeErrors()).toHaveLength(10);
  });

  it('tells clients of their own mistakes, never of those of others [TD-17] [EC-16]', async () => {
    const { ada, ben } = await createPair();
    await ben.subscribe({ subscribeTopics: ['/a', '/info/x'], subscribeTopicRegexp: ['.*'] });
    ada.publish('/a', 'double', 1);
    ada.sendRecords(Uint8Array.of(0xff));
    ada.sendRecords(encodeRecord({ topic: '/info/x', format: 'double', value: 1 }));
    ada.sendRecords(encodeRecord({ topic: '', format: 'double', value: 1 }));
    ada.sendText('PANG');
    expect(ada.takeErrors()).toHaveLength(4);
    ada.drop();
    expect(ben.takeSent().map(({ kind }) => kind)).toEqual(['record']);
  });

  it('closes a socket after more than 20 unreadable frames in 10 s [TD-18]', async () => {
    const { ada, master } = await createPair();
    const garbage = Uint8Array.of(0x12, 0xff);
    for (let i = 0; i < 20; i++) ada.socket.handleTopicData(garbage);
    expect(ada.closed).toBeUndefined();
    master.clock.advanceSync(5_000);
    ada.socket.handleTopicData(garbage);
    expect(ada.closed).toEqual({ reason: 'protocol errors' });
    ada.socket.handleTopicData(garbage);
    // It may come back.
    expect(ada.open()).toBe(true);
    ada.publish('/a', 'double', 1);
    expect(ada.closed).toBeUndefined();
  });

  it('bears unreadable frames now and then [TD-18]', async () => {
    const { ada, master } = await createPair();
    for (let i = 0; i < 100; i++) {
      ada.socket.handleTopicData(Uint8Array.of(0x12, 0xff));
      master.clock.advanceSync(501);
    }
    expect(ada.closed).toBeUndefined();
  });

  it('gives a topic to the client that published while it held no value [TD-19]', async () => {
    const { ada, ben, master } = await createPair();
    const cleo = await master.legacy('cleo');
    ada.publish('/a', 'double', 1);
    ben.publish('/a', 'double', 2);
    // Ben published on it, too, but it is Ada's.
    await ben.call({ topic: '/services/client/deregistration', client: { id: ben.id } });
    await cleo.subscribe({ subscribeTopics: ['/a'] });
    expect(cleo.takeValues()).toEqual([['/a', 2]]);
    await ada.call({ topic: '/services/client/deregistration', client: { id: ada.id } });
    const { stringList } = await master.call({ topic: '/services/topic_list' });
    expect(stringList?.elements).not.toContain('/a');
    // The next publisher owns it.
    cleo.publish('/a', 'double', 3);
    await cleo.call({ topic: '/services/client/deregistration', client: { id: cleo.id } });
    const after = await master.call({ topic: '/services/topic_list' });
    expect(after.stringList?.elements).not.toContain('/a');
  });
});
