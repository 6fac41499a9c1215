import { ClientState } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { DEFAULT_LIMITS } from '../src/index.ts';
import { TestMaster } from '../src/testing/index.ts';

const { ACTIVE, INACTIVE, UNAVAILABLE } = ClientState;

async function createAda(limits = {}) {
  const master = new TestMaster({ limits });
  const ada = await master.legacy('ada');
  const { clock } = master;
  const state = async (): Promise<number | undefined> => {
    const { clientList } = await master.call({ topic: '/services/client/get_list' });
    return clientList!.elements.find(({ id }) => id === ada.id)?.state;
  };
  return { master, clock, ada, state };
}

describe('liveness', () => {
  it('goes from active to inactive to unavailable, and back with its next activity [CL-10] [CL-13]', async () => {
    const { clock, ada, state } = await createAda();
    const seen = [await state()];
    clock.advanceSync(4_999);
    seen.push(await state());
    clock.advanceSync(501);
    seen.push(await state());
    ada.sendText('PONG');
    seen.push(await state());
    clock.advanceSync(9_500);
    seen.push(await state());
    clock.advanceSync(500);
    seen.push(await state());
    ada.sendText('PONG');
    seen.push(await state());
    expect(seen).toEqual([ACTIVE, ACTIVE, INACTIVE, ACTIVE, INACTIVE, UNAVAILABLE, ACTIVE]);
  });

  it.each([
    ['a record', (ada) => ada.publish('/a', 'double', 1)],
    ['garbage', (ada) => ada.socket.handleTopicData(Uint8Array.of(1, 2, 3))],
    ['PING', (ada) => ada.sendText('PING')],
    ['any text', (ada) => ada.sendText('hello')],
    ['a service request', (ada) => ada.subscribe({ subscribeTopics: ['/a'] })],
    [
      'a request about a device',
      (ada) => ada.call({ topic: '/services/device/get', device: { clientId: ada.id } }),
    ],
  ] as [string, (ada: Awaited<ReturnType<typeof createAda>>['ada']) => unknown][])(
    'counts %s as activity [CL-11]',
    async (_, sign) => {
      const { clock, ada, state } = await createAda();
      clock.advanceSync(20_000);
      expect(await state()).toBe(UNAVAILABLE);
      await sign(ada);
      expect(await state()).toBe(ACTIVE);
    },
  );

  it('does not count the request of another as activity [CL-11]', async () => {
    const { master, clock, ada, state } = await createAda();
    clock.advanceSync(20_000);
    await master.call({ topic: '/services/client/get_list' });
    await master.call({ topic: '/services/client/registration', client: { id: ada.id } });
    expect(await state()).toBe(UNAVAILABLE);
  });

  it('pings clients that are silent for two and a half seconds, every half second [CL-12]', async () => {
    const { clock, ada } = await createAda();
    const pings = () => ada.takeSent().filter(({ kind }) => kind === 'PING').length;
    clock.advanceSync(2_499);
    expect(pings()).toBe(0);
    clock.advanceSync(1);
    expect(pings()).toBe(1);
    clock.advanceSync(1_000);
    expect(pings()).toBe(2);
    ada.sendText('PONG');
    clock.advanceSync(2_499);
    expect(pings()).toBe(0);
  });

  it('pings active clients, too, to measure the latency [CL-12]', async () => {
    const { clock, ada } = await createAda();
    let pings = 0;
    for (let i = 0; i < 110; i++) {
      ada.publish('/a', 'double', i);
      clock.advanceSync(100);
      for (const { kind } of ada.takeSent()) {
        if (kind !== 'PING') continue;
        pings++;
        ada.sendText('PONG');
      }
    }
    expect(pings).toBe(2);
  });

  it('notices a closed socket at once, and counts from there [CL-13]', async () => {
    const { clock, ada, state } = await createAda();
    clock.advanceSync(4_000);
    ada.sendText('PONG');
    ada.drop();
    expect(await state()).toBe(INACTIVE);
    clock.advanceSync(9_500);
    expect(await state()).toBe(INACTIVE);
    clock.advanceSync(500);
    expect(await state()).toBe(UNAVAILABLE);
  });

  it('ends the values of an unavailable client, but not its subscriptions [CL-13]', async () => {
    const { master, clock, ada } = await createAda();
    await ada.subscribe({ subscribeTopics: ['/b'] });
    ada.publish('/a', 'double', 1);
    ada.drop();
    clock.advanceSync(10_500);
    const { stringList } = await master.call({ topic: '/services/topic_list' });
    expect(stringList?.elements).not.toContain('/a');
    ada.open();
    const ben = await master.legacy('ben');
    ben.publish('/b', 'double', 2);
    expect(ada.takeValues()).toEqual([['/b', 2]]);
  });

  it('makes a client that never opens a socket unavailable, and still answers it [CL-13]', async () => {
    const { master, clock } = await createAda();
    const cleo = await master.register({ name: 'cleo' });
    clock.advanceSync(10_000);
    const { clientList } = await master.call({ topic: '/services/client/get_list' });
    expect(clientList?.elements.find(({ id }) => id === cleo.id)?.state).toBe(UNAVAILABLE);
    await cleo.subscribe({ subscribeTopics: ['/a'] });
    expect(cleo.open()).toBe(true);
  });

  it('removes a client that was unavailable for too long [CL-14]', async () => {
    const { clock, ada, state, master } = await createAda();
    await ada.subscribe({ subscribeTopics: ['/a'] });
    ada.drop();
    clock.advanceSync(10_000 + DEFAULT_LIMITS.unavailableRetentionMs - 1);
    expect(await state()).toBe(UNAVAILABLE);
    clock.advanceSync(501);
    expect(await state()).toBeUndefined();
    expect(ada.open()).toBe(false);
    expect(ada.closed).toEqual({ reason: 'unknown client' });
    const { topicStatistics } = await master.call({
      topic: '/services/ubii/topic_statistics',
      topicStatisticsRequest: {},
    });
    expect(topicStatistics?.elements).toEqual([]);
  });

  it('removes the client that has been offline longest at the limit [CL-14]', async () => {
    const { master, clock, ada, state } = await createAda({ clients: 3 });
    const ben = await master.legacy('ben');
    const cleo = await master.legacy('cleo');
    await expect(master.register({ name: 'dora' })).rejects.toThrow(
      'more than 3 clients (limit clients',
    );
    ben.drop();
    clock.advanceSync(500);
    cleo.drop();
    for (let i = 0; i < 24; i++) {
      clock.advanceSync(500);
      ada.sendText('PONG');
    }
    await master.register({ name: 'dora' });
    const { clientList } = await master.call({ topic: '/services/client/get_list' });
    expect(clientList?.elements.map(({ name }) => name)).toEqual(['ada', 'cleo', 'dora']);
    expect(await state()).toBe(ACTIVE);
  });

  it('removes those first that never had a socket [CL-14]', async () => {
    const { master, clock, ada, state } = await createAda({ clients: 2 });
    ada.drop();
    clock.advanceSync(500);
    await master.register({ name: 'stranger' });
    clock.advanceSync(11_000);
    await master.register({ name: 'ben' });
    const { clientList } = await master.call({ topic: '/services/client/get_list' });
    expect(clientList?.elements.map(({ name }) => name)).toEqual(['ada', 'ben']);
    expect(await state()).toBe(UNAVAILABLE);
  });

  it('measures latency from the last PING to its PONG [CL-15]', async () => {
    const { master, clock, ada } = await createAda();
    const latency = async () => {
      const { clientList } = await master.call({ topic: '/services/latency_clients_list' });
      return clientList?.elements.map(({ id, latency: ms }) => [id, ms]);
    };
    clock.advanceSync(3_000);
    clock.advanceSync(30);
    ada.sendText('PONG');
    expect(await latency()).toEqual([[ada.id, 30]]);
    // A PONG without a PING is not measured.
    clock.advanceSync(100);
    ada.sendText('PONG');
    expect(await latency()).toEqual([[ada.id, 30]]);
  });

  it('removes a client with everything of it when it is deregistered [CL-16]', async () => {
    const { master, ada, state } = await createAda();
    const ben = await master.legacy('ben');
    await ada.subscribe({ subscribeTopics: ['/b'], subscribeTopicRegexp: ['^/c'] });
    await ada.call({
      topic: '/services/device/registration',
      device: { clientId: ada.id, components: [{ topic: '/a' }] },
    });
    ada.publish('/a', 'double', 1);
    const reply = await ada.call({
      topic: '/services/client/deregistration',
      client: ada.registered,
    });
    expect(reply.success).toBeDefined();
    expect(ada.closed).toEqual({ reason: 'deregistered' });
    expect(await state()).toBeUndefined();
    const { deviceList } = await master.call({ topic: '/services/device/get_list' });
    expect(deviceList?.elements).toEqual([]);
    ada.socket.handleTopicData(new Uint8Array(4));
    ada.socket.handleClose('lost');
    ben.publish('/b', 'double', 2);
    ben.publish('/c', 'double', 3);
    const { topicStatistics } = await master.call({
      topic: '/services/ubii/topic_statistics',
      topicStatisticsRequest: {},
    });
    expect(
      topicStatistics?.elements.filter(({ topic }) => !topic.startsWith('/info/')),
    ).toMatchObject([
      { topic: '/b', subscribers: 0 },
      { topic: '/c', subscribers: 0 },
    ]);
  });

  it.each([
    ['unknown', 'not_found'],
    ['', 'invalid_argument'],
  ])('answers the deregistration of %j with %s [CL-16]', async (id, code) => {
    const { master } = await createAda();
    const { error } = await master.call({
      topic: '/services/client/deregistration',
      client: { id },
    });
    expect(error).toMatchObject({ code });
  });
});
