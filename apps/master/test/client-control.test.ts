import { StatusEventKind } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TestMaster, type TestClient } from '../src/testing/index.ts';
import { ClientWorld } from './client-world.ts';

async function createRoom() {
  const master = new TestMaster();
  const mara = await master.extension('Mara');
  const ben = await master.extension('Ben');
  return { master, mara, ben };
}

const names = async (master: TestMaster) => {
  const { clientList } = await master.call({ topic: '/services/client/get_list' });
  return clientList!.elements.map(({ name }) => name);
};

describe('renaming a client', () => {
  const rename = (master: TestMaster, target: TestClient, name: string, by?: TestClient) =>
    master.call({
      topic: '/services/ubii/client_rename',
      clientRenameRequest: { clientId: by?.id ?? '', targetId: target.id, name },
    });

  it('is announced to all clients, with the actor [EX-29] [CL-31]', async () => {
    const { master, mara, ben } = await createRoom();
    await mara.subscribe({ subscribeTopics: [`/ubii/client/${ben.id}`] });
    mara.takeSent();
    expect(await rename(master, ben, 'Phone 2', mara)).toMatchObject({
      client: { id: ben.id, name: 'Phone 2' },
    });
    expect(mara.takeRecords()).toMatchObject([{ value: { name: 'Phone 2' } }]);
    const { masterStatus } = await master.call({
      topic: '/services/ubii/master_status',
      masterStatusRequest: {},
    });
    expect(masterStatus!.events.at(-1)).toMatchObject({
      kind: StatusEventKind.CLIENT_RENAMED,
      text: 'Ben was renamed to Phone 2 by Mara',
      clientId: ben.id,
    });
  });

  it('stands until the client says another name than before [EX-29]', async () => {
    const { master, ben } = await createRoom();
    await rename(master, ben, 'Phone 2');
    const again = (name: string) =>
      master.register({ id: ben.id, name, extension: { resumeToken: ben.token! } });
    await again('Ben');
    expect(await names(master)).toEqual(['Mara', 'Phone 2']);
    await again('Benjamin');
    expect(await names(master)).toEqual(['Mara', 'Benjamin']);
  });

  it.each(['', ' ', ' Ben', 'a\nb'])('refuses the name %j [EX-29]', async (name) => {
    const { master, ben } = await createRoom();
    expect((await rename(master, ben, name)).error?.code).toBe('invalid_argument');
    expect(await names(master)).toEqual(['Mara', 'Ben']);
  });

  it('needs a client that is there', async () => {
    const { master, ben } = await createRoom();
    await master.call({ topic: '/services/client/deregistration', client: { id: ben.id } });
    expect((await rename(master, ben, 'x')).error?.code).toBe('not_found');
  });
});

describe('disconnecting a client', () => {
  const disconnect = (master: TestMaster, targetId: string, reason: string, clientId = '') =>
    master.call({
      topic: '/services/ubii/client_disconnect',
      clientDisconnectRequest: { clientId, targetId, reason },
    });

  it('removes the client, and reports actor and reason [EX-30]', async () => {
    const { master, mara, ben } = await createRoom();
    ben.publish('/a', 'double', 1);
    expect(await disconnect(master, ben.id, 'too loud', mara.id)).toHaveProperty('success');
    expect(ben.closed).toEqual({ reason: 'disconnected', explanation: 'by Mara: too loud' });
    expect(await names(master)).toEqual(['Mara']);
    const { masterStatus } = await master.call({
      topic: '/services/ubii/master_status',
      masterStatusRequest: {},
    });
    expect(masterStatus!.events.at(-1)).toMatchObject({
      kind: StatusEventKind.CLIENT_DISCONNECTED,
      text: 'Ben was disconnected by Mara: too loud',
    });
    expect(masterStatus!.events.map(({ text }) => text)).not.toContain('Ben left');
    const { stringList } = await master.call({ topic: '/services/topic_list' });
    expect(stringList!.elements).not.toContain('/a');
  });

  it('says so in one line that is cut, whatever the reason [EX-30]', async () => {
    const { master, ben } = await createRoom();
    await disconnect(master, ben.id, `😀${'ö\u0000'.repeat(5000)}`);
    expect(ben.closed!.explanation).toMatch(/^by an admin: 😀[ö ]{198,199}$/u);
  });

  it('tells a client that was away when it comes back, and lets it register again [EX-30]', async () => {
    const { master, ben } = await createRoom();
    ben.drop();
    await disconnect(master, ben.id, 'the lesson is over');
    expect(ben.open()).toBe(false);
    expect(ben.closed).toEqual({
      reason: 'disconnected',
      explanation: 'by an admin: the lesson is over',
    });
    const back = await master.register({
      id: ben.id,
      name: 'Ben',
      extension: { resumeToken: ben.token! },
    });
    expect(back.id).toBe(ben.id);
    expect(back.open()).toBe(true);
  });

  it('is final for clients of our library, and they tell why [EX-5] [EX-30]', async () => {
    const world = new ClientWorld();
    const { client, states } = await world.connect('phone');
    await disconnect(world.test, client.id, 'too loud');
    await world.pass(60_000);
    expect(states.at(-1)).toMatchObject({
      status: 'closed',
      error: {
        reason: 'disconnected',
        message: 'This client was disconnected by an admin: too loud',
      },
    });
    expect(await names(world.test)).toEqual([]);
    const connected = client.connect();
    await world.pass(1_000);
    await connected;
    expect(await names(world.test)).toEqual(['phone']);
  });
});

describe('throttling a client', () => {
  const throttle = (
    master: TestMaster,
    target: TestClient,
    recordsPerSecond: number,
    more: { clientId?: string; reason?: string } = {},
  ) =>
    master.call({
      topic: '/services/ubii/client_throttle',
      clientThrottleRequest: { targetId: target.id, recordsPerSecond, ...more },
    });
  const activity = async (master: TestMaster, { id }: TestClient) => {
    const { clientReport } = await master.call({
      topic: '/services/ubii/client_report',
      clientReportRequest: { clientIds: [id] },
    });
    return clientReport!.clients[0]!;
  };

  it('lets so many records a second through, drops and counts the rest [EX-31] [EX-32]', async () => {
    const { master, mara, ben } = await createRoom();
    await mara.subscribe({ subscribeTopics: ['/a'] });
    mara.takeSent();
    await throttle(master, ben, 5);
    for (let i = 0; i < 20; i++) ben.publish('/a', 'double', i);
    expect(mara.takeValues()).toHaveLength(5);
    master.clock.advanceSync(1_000);
    for (let i = 0; i < 20; i++) ben.publish('/a', 'double', i);
    expect(mara.takeValues()).toHaveLength(5);
    expect(await activity(master, ben)).toMatchObject({
      recordsIn: 10,
      refused: 30,
      throttle: { recordsPerSecond: 5, dropped: 30, byPolicy: false },
    });
    // Other clients are not affected.
    for (let i = 0; i < 20; i++) mara.publish('/a', 'double', i);
    expect(mara.takeValues()).toHaveLength(20);
  });

  it('reports actor and reason to the client and to the others [EX-33]', async () => {
    const { master, mara, ben } = await createRoom();
    await throttle(master, ben, 1, { clientId: mara.id, reason: 'too\nloud' });
    const text = 'throttled to 1 records per second by Mara: too loud';
    expect(ben.takeErrors()).toMatchObject([
      {
        code: 'resource_exhausted',
        message: `This client is ${text}. Records above this rate are dropped.`,
      },
    ]);
    ben.publish('/a', 'double', 1);
    ben.publish('/a', 'double', 2);
    expect(ben.takeErrors()).toMatchObject([
      { message: `The record on "/a" was dropped: this client is ${text}.` },
    ]);
    const { masterStatus } = await master.call({
      topic: '/services/ubii/master_status',
      masterStatusRequest: {},
    });
    expect(masterStatus!.problems).toMatchObject([
      {
        code: 'client_throttled',
        clientId: ben.id,
        text: `Ben is ${text}; 1 of its records were dropped so far.`,
        remedy: 'Publish less, or remove the throttle.',
      },
    ]);
  });

  it('ends when it is lifted, and stands while the client is away [EX-31]', async () => {
    const { master, ben } = await createRoom();
    await throttle(master, ben, 1);
    ben.drop();
    ben.open();
    for (let i = 0; i < 10; i++) ben.publish('/a', 'double', i);
    expect(await activity(master, ben)).toMatchObject({ recordsIn: 1, throttle: { dropped: 9 } });
    await throttle(master, ben, 0);
    for (let i = 0; i < 10; i++) ben.publish('/a', 'double', i);
    const { recordsIn, throttle: none } = await activity(master, ben);
    expect([recordsIn, none]).toEqual([11, undefined]);
  });

  it('lets a slow one through as well [EX-31]', async () => {
    const { master, ben } = await createRoom();
    await throttle(master, ben, 0.1);
    for (let second = 0; second < 20; second++) {
      ben.publish('/a', 'double', second);
      master.clock.advanceSync(1_000);
    }
    expect((await activity(master, ben)).recordsIn).toBe(2);
  });

  it.each([-1, 0.01, Number.NaN, Number.POSITIVE_INFINITY])(
    'refuses %d records [EX-31]',
    async (rate) => {
      const { master, ben } = await createRoom();
      expect((await throttle(master, ben, rate)).error?.code).toBe('invalid_argument');
    },
  );

  it('is seen by a client of our library as a problem [EX-33]', async () => {
    const world = new ClientWorld();
    const { client, problems } = await world.connect('phone');
    await world.test.call({
      topic: '/services/ubii/client_throttle',
      clientThrottleRequest: { targetId: client.id, recordsPerSecond: 2 },
    });
    await world.pass(100);
    expect(problems.map(({ message }) => message)).toEqual([
      'This client is throttled to 2 records per second. Records above this rate are dropped.',
    ]);
  });
});
