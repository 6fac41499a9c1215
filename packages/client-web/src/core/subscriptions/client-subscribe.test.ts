import { ServiceError } from '@ubii/proto';
import type { TopicRecord } from '@ubii/proto';
import { settle } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { createTestClient } from '../../testing/create-test-client.ts';
import { FakeMaster } from '../../testing/fake-master.ts';
import type { Subscription } from './subscription.ts';

async function setup() {
  const master = new FakeMaster();
  const all = createTestClient(master);
  await all.client.connect();
  return { master, ...all };
}

const requestsOf = (master: FakeMaster) =>
  master.requests.flatMap(({ topicSubscription }) => topicSubscription ?? []);

function collect(subscription: Subscription): TopicRecord[] {
  const records: TopicRecord[] = [];
  subscription.onRecord((record) => records.push(record));
  return records;
}

describe('client.subscribe()', () => {
  it('asks the master for the first subscriber of a pattern and leaves with the last', async () => {
    const { master, client } = await setup();
    const first = client.subscribe('/a');
    const second = client.subscribe('/a');
    await Promise.all([first.ready, second.ready]);
    await first.close();
    expect(requestsOf(master)).toHaveLength(1);
    expect(master.holds(client.id).topics).toEqual(['/a']);
    await second.close();
    expect(requestsOf(master)).toHaveLength(2);
    expect(master.holds(client.id).topics).toEqual([]);
  });

  it('asks for everything of one turn in one request', async () => {
    const { master, client } = await setup();
    const all = ['/a', '/b', '/c'].map((topic) => client.subscribe(topic));
    all.push(client.subscribe({ glob: '/x/*' }), client.subscribe({ regex: 'y$' }));
    await Promise.all(all.map(({ ready }) => ready));
    expect(requestsOf(master)).toHaveLength(1);
    expect(master.holds(client.id)).toMatchObject({
      topics: ['/a', '/b', '/c'],
      regexes: ['^/x/[^/]*$', 'y$'],
    });
  });

  it('asks for nothing when a subscription is closed in the turn it was made', async () => {
    const { master, client } = await setup();
    const subscription = client.subscribe('/a');
    await subscription.close();
    await settle();
    expect(requestsOf(master)).toEqual([]);
  });

  it('lets no request overtake another', async () => {
    const { master, client } = await setup();
    const first = client.subscribe('/a');
    await Promise.resolve();
    const closed = first.close();
    const second = client.subscribe('/a');
    await Promise.all([closed, second.ready]);
    await settle();
    expect(master.holds(client.id).topics).toEqual(['/a']);
  });

  it('splits very many topics into several requests', async () => {
    const { master, client } = await setup();
    const all = Array.from({ length: 2_500 }, (_, i) => client.subscribe(`/t${i}`));
    await Promise.all(all.map(({ ready }) => ready));
    expect(requestsOf(master).map((request) => request.subscribeTopics.length)).toEqual([
      1_000, 1_000, 500,
    ]);
  });

  it('hands a record that several subscriptions match to each of them once', async () => {
    const { master, client } = await setup();
    const subscriptions = [
      client.subscribe('/a/x'),
      client.subscribe('/a/x'),
      client.subscribe({ glob: '/a/*' }),
      client.subscribe({ regex: '^/a' }),
    ];
    const received = subscriptions.map(collect);
    await Promise.all(subscriptions.map(({ ready }) => ready));
    master.publish({ topic: '/a/x', format: 'double', value: 1 });
    await settle();
    expect(received.map((records) => records.length)).toEqual([1, 1, 1, 1]);
  });

  it('delivers records of its own as well [TD-14]', async () => {
    const { client } = await setup();
    const subscription = client.subscribe('/a');
    const records = collect(subscription);
    await subscription.ready;
    client.publish('/a', 'vector2', { x: 1, y: 2 }, { immediate: true });
    await settle();
    expect(records).toMatchObject([
      { topic: '/a', format: 'vector2', value: { x: 1, y: 2 }, clientId: client.id },
    ]);
  });

  it('delivers only the wanted format', async () => {
    const { master, client } = await setup();
    const records: TopicRecord<'double'>[] = [];
    client.subscribe('/a', { format: 'double' }).onRecord((record) => records.push(record));
    await settle();
    master.publish({ topic: '/a', format: 'string', value: 'x' });
    master.publish({ topic: '/a', format: 'double', value: 1 });
    master.publish({ topic: '/a' });
    await settle();
    expect(records.map(({ value }) => value)).toEqual([1]);
  });

  it('gives the retained record to a second subscriber of the same pattern', async () => {
    const { master, client } = await setup();
    master.publish({ topic: '/a', format: 'double', value: 1 });
    const first = collect(client.subscribe('/a'));
    await settle();
    const second = collect(client.subscribe('/a'));
    await settle();
    expect(first).toHaveLength(1);
    expect(second).toHaveLength(1);
    expect(requestsOf(master)).toHaveLength(1);
  });

  it('gives the retained record to a second subscriber who wants it at another rate', async () => {
    const { master, client } = await setup();
    master.publish({ topic: '/a', format: 'double', value: 1 });
    const first = collect(client.subscribe('/a', { maxRateHz: 8 }));
    await settle();
    const faster = client.subscribe('/a');
    const second = collect(faster);
    await faster.ready;
    expect(first).toHaveLength(1);
    expect(second).toHaveLength(1);
  });

  it('gives the retained record to a subscriber in the turn in which the last one leaves', async () => {
    const { master, client } = await setup();
    master.publish({ topic: '/a', format: 'double', value: 1 });
    const first = client.subscribe('/a');
    collect(first);
    await settle();
    const closed = first.close();
    const second = collect(client.subscribe('/a'));
    await closed;
    await settle();
    expect(second).toHaveLength(1);
    expect(master.holds(client.id).topics).toEqual(['/a']);
  });

  it('keeps what comes before the first consumer for him', async () => {
    const { master, client } = await setup();
    master.publish({ topic: '/a', format: 'double', value: 1 });
    const subscription = client.subscribe('/a');
    await subscription.ready;
    await settle();
    const records = collect(subscription);
    expect(records).toEqual([]); // not within onRecord
    await settle();
    expect(records).toHaveLength(1);
  });

  it('iterates, in order, beside callbacks', async () => {
    const { master, client } = await setup();
    const subscription = client.subscribe('/a', { format: 'double' });
    const called: number[] = [];
    subscription.onRecord(({ value }) => called.push(value));
    const iterated: number[] = [];
    const loop = (async () => {
      for await (const { value } of subscription) {
        iterated.push(value);
        if (value === 3) break;
      }
    })();
    await subscription.ready;
    for (const value of [1, 2, 3]) master.publish({ topic: '/a', format: 'double', value });
    await loop;
    expect(iterated).toEqual([1, 2, 3]);
    expect(called).toEqual([1, 2, 3]);
  });

  it('drops and counts the oldest records of a slow loop', async () => {
    const { master, client } = await setup();
    const subscription = client.subscribe('/a', { format: 'double', bufferSize: 2 });
    const iterator = subscription[Symbol.asyncIterator]();
    await subscription.ready;
    for (const value of [1, 2, 3, 4]) master.publish({ topic: '/a', format: 'double', value });
    await settle();
    expect(subscription.dropped).toBe(2);
    expect((await iterator.next()).value).toMatchObject({ value: 3 });
    await iterator.return?.();
    expect(subscription.dropped).toBe(2);
  });

  it('asks the master for the fastest rate of a pattern, and limits the others itself [TD-28]', async () => {
    const { master, client, clock } = await setup();
    const slow = collect(client.subscribe('/a', { maxRateHz: 1 }));
    await settle();
    const fast = client.subscribe('/a', { maxRateHz: 10 });
    const fastRecords = collect(fast);
    await settle();
    expect(requestsOf(master).map(({ maxRateHz }) => maxRateHz)).toEqual([1, 10]);
    for (let value = 0; value < 10; value++) {
      master.publish({ topic: '/a', format: 'double', value });
      await clock.advance(100);
    }
    expect(slow.map(({ value }) => value)).toEqual([0, 9]);
    expect(fastRecords).toHaveLength(10);
    await fast.close();
    expect(requestsOf(master).at(-1)?.maxRateHz).toBe(1);
  });

  it('rejects ready, ends and tells when the master refuses the pattern [TD-21]', async () => {
    const { master, client, problems } = await setup();
    master.onRequest = ({ topicSubscription }) =>
      topicSubscription?.subscribeTopicRegexp.includes('(x)')
        ? new ServiceError('invalid_argument', 'too many of them')
        : undefined;
    const refused = client.subscribe({ regex: '(x)' });
    const others = [client.subscribe('/a'), client.subscribe({ regex: 'b' })];
    const loop = (async () => {
      for await (const _ of refused);
    })();
    await expect(refused.ready).rejects.toMatchObject({ code: 'invalid_argument' });
    await expect(loop).rejects.toThrow('too many');
    await Promise.all(others.map(({ ready }) => ready));
    expect(master.holds(client.id)).toMatchObject({ topics: ['/a'], regexes: ['b'] });
    expect(problems).toMatchObject([{ code: 'invalid_argument' }]);
    await refused.close();
  });

  it('tries again when a request does not get through though the link is up', async () => {
    const { master, client, clock } = await setup();
    master.isDown = true;
    const subscription = client.subscribe('/a');
    await settle();
    master.isDown = false;
    await clock.advance(1_000);
    await subscription.ready;
    expect(client.state.status).toBe('connected');
  });

  it('registers again when the master says it does not know the client', async () => {
    const { master, client, clock } = await setup();
    master.forget(client.id);
    const subscription = client.subscribe('/a');
    await clock.advance(1_000);
    await subscription.ready;
    expect(client.state).toMatchObject({ status: 'connected', clientId: 'client-1' });
  });

  it('ends its loops with the error when the client is superseded; callbacks stand', async () => {
    const { master, client } = await setup();
    const subscription = client.subscribe('/a');
    const records = collect(subscription);
    const loop = (async () => {
      for await (const _ of subscription);
    })();
    await subscription.ready;
    master.drop(4001);
    await expect(loop).rejects.toMatchObject({ reason: 'superseded' });
    await client.connect();
    master.publish({ topic: '/a', format: 'double', value: 1 });
    await settle();
    expect(records).toHaveLength(1);
  });
});

describe('client.subscribe() by component profile [TD-27]', () => {
  async function setupTwo() {
    const { master, client: ada, clock } = await setup();
    const { client: ben } = createTestClient(master, { name: 'ben', clock });
    await ben.connect();
    return { master, ada, ben, clock };
  }

  it('receives the topics of matching components, and of none else', async () => {
    const { ada, ben, clock } = await setupTwo();
    const phone = await ben.registerDevice({
      name: 'phone',
      components: [
        { name: 'touch', format: 'vector2', tags: ['touch'] },
        { name: 'pressure', format: 'double' },
      ],
    });
    const subscription = ada.subscribe({ component: { tags: ['touch'] } });
    const records = collect(subscription);
    await subscription.ready;
    phone.component('touch').publish({ x: 1, y: 2 });
    phone.component('pressure').publish(1);
    await clock.advance(0);
    expect(records.map(({ topic }) => topic)).toEqual([phone.component('touch').topic]);
  });

  it('receives the topics of devices that come later', async () => {
    const { ada, ben, clock } = await setupTwo();
    const records = collect(ada.subscribe({ component: { format: 'vector2' } }));
    await clock.advance(0);
    const phone = await ben.registerDevice({
      name: 'phone',
      components: [{ name: 'touch', format: 'vector2' }],
    });
    for (const x of [1, 2, 3]) phone.component('touch').publish({ x, y: 0 });
    await clock.advance(20);
    expect(records.map(({ value }) => (value as { x: number }).x)).toEqual([1, 2, 3]);
  });

  it('keeps profiles and topics apart', async () => {
    const { ada, ben, clock } = await setupTwo();
    const byProfile = collect(ada.subscribe({ component: { name: 'touch' } }));
    const byGlob = collect(ada.subscribe({ glob: '/**' }));
    const phone = await ben.registerDevice({
      name: 'phone',
      components: [{ name: 'touch', format: 'double' }],
    });
    ben.publish('/other', 'double', 1);
    phone.component('touch').publish(2);
    await clock.advance(20);
    expect(byProfile.map(({ value }) => value)).toEqual([2]);
    expect(byGlob.map(({ value }) => value)).toEqual([1, 2]);
  });

  it('follows a device that is announced and one that goes', async () => {
    const { master, ada, clock } = await setupTwo();
    const records = collect(ada.subscribe({ component: { name: 'touch' } }));
    await clock.advance(0);
    expect(master.holds(ada.id).topics).toEqual(['/info/device/delete', '/info/device/new']);
    const device = {
      id: 'd',
      name: 'phone',
      components: [{ id: 'c', name: 'touch', topic: '/t', deviceId: 'd' }],
    };
    master.publish({ topic: '/info/device/new', format: 'device', value: device });
    await settle();
    const listed = master.requests.filter(({ topic }) => topic.includes('component/get_list'));
    ada.subscribe('/t').onRecord(() => undefined);
    await settle();
    master.publish({ topic: '/t', format: 'double', value: 1 });
    await settle();
    expect(records).toHaveLength(1);
    expect(master.requests.filter(({ topic }) => topic.includes('component/get_list'))).toEqual(
      listed,
    );
    master.publish({ topic: '/info/device/delete', format: 'device', value: device });
    await settle();
    master.publish({ topic: '/t', format: 'double', value: 2 });
    await settle();
    expect(records).toHaveLength(1);
  });

  it('leaves nothing behind when the last profile goes', async () => {
    const { master, ada, clock } = await setupTwo();
    const subscription = ada.subscribe({ component: { name: 'touch' } });
    await subscription.ready;
    await subscription.close();
    await clock.advance(0);
    expect(master.holds(ada.id)).toMatchObject({ topics: [], profiles: [] });
  });
});
