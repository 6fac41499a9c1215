import { DEFAULT_LIMITS, type LimitName, type Limits } from '../src/index.ts';
import { TestMaster, type TestClient } from '../src/testing/index.ts';
import { encodeRecord } from '@ubii/proto';
import { describe, expect, it } from 'vitest';

interface House {
  readonly master: TestMaster;
  readonly ada: TestClient;
}

/** For each limit a low maximum and an action that reaches it. */
const WAYS: {
  readonly [L in LimitName]?: readonly [max: number, meet: (house: House) => unknown];
} = {
  frameBytes: [100, ({ ada }) => ada.publish('/a', 'string', 'x'.repeat(100))],
  topicBytes: [10, ({ ada }) => ada.publish('/1234567890', 'double', 1)],
  topics: [4, publishTopics],
  topicsPerClient: [4, publishTopics],
  retainedBytes: [2000, ({ ada }) => ada.publish('/a', 'string', 'x'.repeat(2000))],
  recordsPerSecond: [10, publishOften],
  publishedBytesPerSecond: [200, publishOften],
  protocolErrors: [
    2,
    ({ ada }) => {
      for (let i = 0; i < 3; i++) ada.socket.handleTopicData(Uint8Array.of(0xff));
    },
  ],
  clients: [1, ({ master }) => register(master, {})],
  sockets: [
    1,
    async ({ master }) => {
      const ben = await master.register({ name: 'ben' });
      expect(ben.open()).toBe(false);
      expect(ben.closed).toEqual({ reason: 'too many' });
    },
  ],
  devicesPerClient: [1, async ({ ada }) => refused(await twoDevices(ada))],
  componentsPerDevice: [
    1,
    ({ master }) => register(master, { devices: [{ components: [{}, {}] }] }),
  ],
  registrationBytesPerClient: [
    100,
    ({ master }) => register(master, { description: 'x'.repeat(200) }),
  ],
  registrationBytes: [100, ({ master }) => register(master, { description: 'x'.repeat(200) })],
  subscriptionsPerClient: [1, ({ ada }) => subscribe(ada, { subscribeTopics: ['/a', '/b'] })],
  patternLength: [5, ({ ada }) => subscribe(ada, { subscribeTopicRegexp: ['123456'] })],
  patternsPerClient: [1, ({ ada }) => subscribe(ada, { subscribeTopicRegexp: ['a', 'b'] })],
  patterns: [1, ({ ada }) => subscribe(ada, { subscribeTopicRegexp: ['a', 'b'] })],
  profilesPerClient: [1, ({ ada }) => subscribe(ada, { subscribeComponents: [{}, { id: 'x' }] })],
  profiles: [1, ({ ada }) => subscribe(ada, { subscribeComponents: [{}, { id: 'x' }] })],
  listElements: [1, ({ ada }) => subscribe(ada, { unsubscribeTopics: ['a', 'b'] })],
  listProfiles: [
    1,
    async ({ ada }) =>
      refused(
        await ada.call({ topic: '/services/device/get_list', deviceList: { elements: [{}, {}] } }),
      ),
  ],
};

describe('the limits', () => {
  it.each(Object.entries(WAYS))(
    'answer, count and show the client that reaches %s',
    async (limit, [max, meet]) => {
      const master = new TestMaster({ limits: { [limit]: max } });
      const ada = await master.legacy('ada');
      const error = await meet({ master, ada });
      const errors = [...ada.takeErrors(), ...(isError(error) ? [error] : [])];
      if (limit !== 'protocolErrors' && limit !== 'sockets') {
        expect(errors.at(-1)).toMatchObject({ code: 'resource_exhausted' });
        expect(errors.at(-1)?.message).toContain(limit);
        expect(errors.at(-1)?.message).toContain(String(max));
      }
      const { masterStatus } = await master.call({
        topic: '/services/ubii/master_status',
        masterStatusRequest: {},
      });
      expect(masterStatus?.problems.map(({ text }) => text).join()).toContain(limit);
      expect(masterStatus?.events.map(({ text }) => text).join()).toContain(limit);
      expect(masterStatus?.refused).toBeGreaterThan(0);
      const hits = master.master.metrics().find(({ name }) => name === 'ubii_limit_hits_total');
      expect(hits?.values.find(({ labels }) => labels['limit'] === limit)?.value).toBeGreaterThan(
        0,
      );
      expect(master.log.lines.filter(({ level }) => level === 'warn').length).toBeLessThan(3);
    },
  );

  it('of one client are not those of another', async () => {
    const master = new TestMaster({ limits: { recordsPerSecond: 10, topicsPerClient: 3 } });
    const ada = await master.legacy('ada');
    const ben = await master.legacy('ben');
    await ben.subscribe({ subscribeTopics: ['/ben'] });
    for (let i = 0; i < 1000; i++) ada.publish(`/${i}`, 'double', i);
    for (let i = 0; i < 10; i++) ben.publish('/ben', 'double', i);
    expect(ben.takeValues()).toHaveLength(10);
  });

  it('of a rate let go on after a moment', async () => {
    const master = new TestMaster({ limits: { recordsPerSecond: 10 } });
    const ada = await master.legacy('ada');
    await ada.subscribe({ subscribeTopics: ['/a'] });
    master.clock.advanceSync(1000);
    for (let i = 0; i < 20; i++) ada.publish('/a', 'double', i);
    master.clock.advanceSync(300);
    for (let i = 20; i < 40; i++) ada.publish('/a', 'double', i);
    expect(ada.takeValues().map(([, value]) => value)).toEqual([
      ...[0, 1, 2, 3, 4, 5, 6, 7, 8, 9],
      ...[20, 21, 22],
    ]);
  });

  it('of retained bytes let a value be replaced by one that is no larger', async () => {
    const master = new TestMaster({ limits: { retainedBytes: 2000 } });
    const ada = await master.legacy('ada');
    await ada.subscribe({ subscribeTopics: ['/a'] });
    ada.publish('/a', 'string', 'x'.repeat(1000));
    for (let i = 0; i < 10; i++) ada.publish('/a', 'string', 'y'.repeat(1000));
    expect(ada.takeValues()).toHaveLength(11);
    ada.publish('/b', 'string', 'z'.repeat(1000));
    expect(ada.takeErrors()).toMatchObject([{ code: 'resource_exhausted' }]);
  });

  it('of topics do not hinder those that are there, nor the master', async () => {
    const master = new TestMaster({ limits: { topics: 1 } });
    const ada = await master.legacy('ada');
    ada.publish('/a', 'double', 1);
    await ada.subscribe({ subscribeTopicRegexp: ['.*'] });
    await ada.call({ topic: '/services/device/registration', device: { clientId: ada.id } });
    expect(ada.takeValues().map(([topic]) => topic)).toEqual(['/info/device/new']);
  });

  it('give room back when what took it is gone', async () => {
    const limits: Partial<Limits> = {
      topicsPerClient: 1,
      devicesPerClient: 1,
      registrationBytes: 150,
      retainedBytes: 1000,
      subscriptionsPerClient: 1,
      patterns: 1,
      profiles: 1,
      clients: 1,
      sockets: 1,
    };
    const master = new TestMaster({ limits });
    for (let i = 0; i < 5; i++) {
      const ada = await master.legacy('ada', { description: 'x'.repeat(50) });
      for (let k = 0; k < 3; k++) {
        const { device, error } = await ada.call({
          topic: '/services/device/registration',
          device: { clientId: ada.id, components: [{ topic: '/pen' }] },
        });
        expect(error).toBeUndefined();
        ada.publish('/pen', 'string', 'x'.repeat(100));
        await ada.subscribe({
          subscribeTopics: ['/pen'],
          subscribeTopicRegexp: [`${k}`],
          subscribeComponents: [{ name: `${k}` }],
        });
        await ada.subscribe({
          unsubscribeTopics: ['/pen'],
          unsubscribeTopicRegexp: [`${k}`],
          unsubscribeComponents: [{ name: `${k}` }],
        });
        await ada.call({ topic: '/services/device/deregistration', device: device! });
      }
      expect(ada.takeErrors()).toEqual([]);
      await ada.call({ topic: '/services/client/deregistration', client: { id: ada.id } });
      ada.socket.handleClose('lost');
    }
  });

  it('have numbers that say what they are of', () => {
    for (const [limit, max] of Object.entries(DEFAULT_LIMITS)) {
      expect(Number.isSafeInteger(max) && max > 0, limit).toBe(true);
    }
  });
});

function publishTopics({ ada }: House): void {
  for (let i = 0; i < 10; i++) ada.publish(`/${i}`, 'double', i);
}

function publishOften({ ada }: House): void {
  const record = encodeRecord({ topic: '/a', format: 'double', value: 1 });
  for (let i = 0; i < 20; i++) ada.sendRecords(record);
}

async function twoDevices(client: TestClient) {
  const request = {
    topic: '/services/device/registration',
    device: { clientId: client.id },
  };
  await client.call(request);
  return client.call(request);
}

async function subscribe(client: TestClient, subscription: object) {
  return refused(
    await client.call({
      topic: '/services/topic_subscription',
      topicSubscription: { clientId: client.id, ...subscription },
    }),
  );
}

async function register(master: TestMaster, client: object) {
  return refused(await master.call({ topic: '/services/client/registration', client }));
}

function refused({ error }: { error?: { code: string; message: string } | undefined }) {
  return error;
}

function isError(value: unknown): value is { code: string; message: string } {
  return typeof value === 'object' && value !== null && 'code' in value;
}
