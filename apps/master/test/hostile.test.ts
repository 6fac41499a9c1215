import { Re2Patterns } from '@ubii/patterns/re2';
import { encode, encodeRecord } from '@ubii/proto';
import fc from 'fast-check';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { DEFAULT_LIMITS } from '../src/index.ts';
import { frameOf, TestMaster, type TestClient } from '../src/testing/index.ts';

describe('a hostile client', () => {
  let master: TestMaster;
  let mallory: TestClient;
  let ada: TestClient;
  let ben: TestClient;

  beforeEach(async () => {
    master = new TestMaster({ patterns: new Re2Patterns() });
    ada = await master.legacy('ada');
    ben = await master.extension('ben');
    mallory = await master.legacy('mallory');
    await ben.subscribe({ subscribeTopics: ['/ada'] });
    ben.takeSent();
  });

  // Whatever happened: the others do not notice, and nothing of ours broke.
  afterEach(() => {
    ada.publish('/ada', 'double', 0.5);
    expect(ben.takeValues()).toEqual([['/ada', 0.5]]);
    expect(ada.closed).toBeUndefined();
    expect(ben.closed).toBeUndefined();
    expect(master.log.lines.filter(({ level }) => level === 'error')).toEqual([]);
  });

  it('may send any bytes', () => {
    fc.assert(
      fc.property(fc.uint8Array({ maxLength: 64 }), fc.nat(255), (bytes, tag) => {
        mallory.socket.handleTopicData(bytes);
        mallory.socket.handleTopicData(Uint8Array.of(tag, ...bytes));
        if (mallory.closed !== undefined) mallory.open();
      }),
      { numRuns: 2_000 },
    );
  });

  it('may ask without reading the answers', () => {
    mallory.connection.stall();
    for (let i = 0; i < 1000; i++) mallory.sendText(i % 2 ? 'PING' : `PING ${i}`);
    expect(mallory.takeSent()).toEqual([]);
  });

  it('may send any text', () => {
    fc.assert(
      fc.property(fc.string({ unit: 'binary' }), (text) => {
        mallory.sendText(text);
        if (mallory.closed !== undefined) mallory.open();
      }),
    );
  });

  it('may break good frames anywhere', () => {
    const frame = frameOf([
      encodeRecord({ topic: '/m', format: 'vector2', value: { x: 1, y: 2 } }),
      encode('ubii.topicData.TopicDataRecord', {
        topic: '/m',
        session: { id: 's', processingModules: [{ name: 'm', inputs: [{ internalName: 'i' }] }] },
      }),
    ]);
    for (let length = 0; length < frame.length; length++) {
      mallory.socket.handleTopicData(frame.subarray(0, length));
      const flipped = frame.slice();
      flipped[length]! ^= 0xff;
      mallory.socket.handleTopicData(flipped);
      if (mallory.closed !== undefined) mallory.open();
    }
  });

  it('may send a frame beyond the limit', () => {
    mallory.socket.handleTopicData(new Uint8Array(DEFAULT_LIMITS.frameBytes + 1));
    expect(mallory.takeErrors()).toMatchObject([{ code: 'resource_exhausted' }]);
    expect(mallory.closed).toBeUndefined();
  });

  it('may publish on 10 000 topics', async () => {
    const records = Array.from({ length: 10_000 }, (_, i) =>
      encodeRecord({ topic: `/mallory/${i}`, format: 'double', value: i }),
    );
    for (const record of records) mallory.sendRecords(record);
    expect(mallory.takeErrors()).toEqual([]);
    await ben.subscribe({ subscribeTopics: ['/mallory/9999'] });
    expect(ben.takeValues()).toEqual([['/mallory/9999', 9999]]);
    await mallory.call({ topic: '/services/client/deregistration', client: { id: mallory.id } });
    const { stringList } = await master.call({ topic: '/services/topic_list' });
    expect(stringList?.elements.filter((topic) => topic.startsWith('/mallory'))).toEqual([]);
  });

  it.each([
    '(a+)+$',
    '(a|a)*b',
    '^(([a-z])+.)+[A-Z]([a-z])+$',
    '(.*a){20}',
    '((((a*)*)*)*)*b',
    '(x+x+)+y',
    '[ab]*a[ab]{100}[cd]',
  ])('may subscribe with %s', async (source) => {
    await mallory.subscribe({ subscribeTopicRegexp: [source] });
    for (let i = 0; i < 50; i++) mallory.publish('a'.repeat(1000 - i), 'double', 1);
  });

  it.each(['(a{1000}){1000}', 'a{1000}{1000}', '((a{100}){100}){100}', '(?=a)', '\\1', '('])(
    'may not subscribe with %s',
    async (source) => {
      await expect(mallory.subscribe({ subscribeTopicRegexp: [source] })).rejects.toThrow(
        /^invalid_argument/,
      );
    },
  );

  it('may send requests that are no such', async () => {
    const requests = [
      {},
      { topic: '/services/client/registration', client: { devices: [null, {}, null] } },
      { topic: '/services/client/registration', client: { processingModules: [null] } },
      { topic: '/services/topic_subscription', topicSubscription: { subscribeTopics: [null] } },
      { topic: '/services/device/registration', device: { components: [null, {}] } },
      { topic: '/services/device/get_list', deviceList: { elements: [null] } },
      { topic: '/services/client/get_list', clientList: null },
      { topic: '/services/component/get_list', component: null },
      { topic: '/services/ubii/topic_statistics', topicStatisticsRequest: { cursor: -1e308 } },
      { topic: '/services/ubii/master_status', masterStatusRequest: { sinceMs: 'NaN' } },
      { topic: null, type: 'client' },
    ];
    for (const request of requests) {
      const reply = await master.callJson(request);
      expect(Object.values(reply).filter(Boolean)).toHaveLength(1);
    }
  });

  it('may unsubscribe what is not there, again and again', async () => {
    for (let i = 0; i < 3; i++) {
      await mallory.subscribe({
        unsubscribeTopics: ['/ada', '/a', '/a'],
        unsubscribeTopicRegexp: ['.*', '('],
        unsubscribeComponents: [{}],
      });
    }
  });

  it('may use ids of removed clients or of other clients', async () => {
    await mallory.call({ topic: '/services/client/deregistration', client: { id: mallory.id } });
    const { id } = mallory;
    const requests = [
      { topic: '/services/client/deregistration', client: { id } },
      { topic: '/services/topic_subscription', topicSubscription: { clientId: id } },
      { topic: '/services/device/registration', device: { clientId: id } },
      { topic: '/services/device/deregistration', device: { clientId: id, id } },
      { topic: '/services/device/get', device: { id } },
    ];
    for (const request of requests) {
      expect((await master.call(request)).error).toMatchObject({ code: 'not_found' });
    }
    mallory.publish('/ada', 'double', -1);
    expect(ben.takeSent()).toEqual([]);
    expect(mallory.open()).toBe(false);
    // The socket of an extension client needs the token.
    mallory.registered.id = ben.id;
    expect(mallory.open('guessed')).toBe(false);
  });

  it('may close and open, and talk on a socket that is closed', () => {
    for (let i = 0; i < 100; i++) {
      const { socket } = mallory;
      mallory.open();
      socket.handleClose('lost');
      socket.handleTopicData(frameOf([encodeRecord({ topic: '/m', format: 'double', value: 1 })]));
      socket.handlePing();
      socket.handleDrain();
      socket.handleProtocolError('late');
    }
    expect(
      master.master.metrics().find(({ name }) => name === 'ubii_sockets')?.values[0]?.value,
    ).toBe(3);
  });

  it('may register what others did, and take nothing from them', async () => {
    const { device } = await ada.call({
      topic: '/services/device/registration',
      device: { clientId: ada.id, components: [{ topic: '/ada' }] },
    });
    const { error } = await mallory.call({
      topic: '/services/device/registration',
      device: { ...device!, clientId: mallory.id },
    });
    expect(error).toMatchObject({ code: 'already_exists' });
    const { device: twin } = await mallory.call({
      topic: '/services/device/registration',
      device: { clientId: mallory.id, components: device!.components },
    });
    ada.publish('/ada', 'double', 1);
    ben.takeSent();
    await mallory.call({ topic: '/services/device/deregistration', device: twin! });
    const { stringList } = await master.call({ topic: '/services/topic_list' });
    expect(stringList?.elements).toContain('/ada');
  });

  it('may take nothing from its socket', async () => {
    await mallory.subscribe({ subscribeTopicRegexp: ['.*'] });
    mallory.connection.stall();
    const record = encodeRecord({ topic: '/ada', format: 'string', value: 'x'.repeat(1000) });
    for (let i = 0; i < 20_000; i++) {
      ada.sendRecords(record);
      if (i % 10 === 0) master.clock.endTurnSync();
      if (i % 100 === 0) ben.takeSent();
    }
    master.clock.endTurnSync();
    ben.takeSent();
    expect(mallory.connection.batches).toEqual([]);
  });
});
