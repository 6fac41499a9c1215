import { ServiceError } from '@ubii/proto';
import { settle } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { createTestClient } from '../../testing/create-test-client.ts';
import { FakeMaster } from '../../testing/fake-master.ts';

const URLS = ['http://a', 'http://b', 'http://c'] as const;

/** Three masters of a cluster, and a client of the first whose link has held. */
async function setup(options: Parameters<typeof createTestClient>[1] = {}) {
  const masters = URLS.map(() => new FakeMaster());
  const [a, b, c] = masters as [FakeMaster, FakeMaster, FakeMaster];
  masters.forEach((master, at) => {
    master.masters = URLS.filter((_, i) => i !== at);
    master.masterId = `master-${at}`;
  });
  const others = new Map(URLS.map((url, at) => [url, masters[at]!]));
  const test = createTestClient(a, { url: URLS[0], others, ...options });
  const moves: unknown[] = [];
  test.client.onMaster((change) => moves.push(change));
  await test.client.connect();
  await test.clock.advance(10_000);
  test.states.length = 0;
  return { a, b, c, moves, ...test };
}

const topicsOf = (master: FakeMaster): string[] => master.requests.map(({ topic }) => topic);

describe('a client whose master dies [CU-80]', () => {
  it('goes on at another one as itself, with its subscriptions and devices', async () => {
    // Chance 0: the others are asked in the order in which they were told, the last one first.
    const { a, b, c, client, clock, moves, states } = await setup({ random: () => 0 });
    const values: unknown[] = [];
    await client.subscribe('/x').onRecord(({ value }) => values.push(value)).ready;
    const device = await client.registerDevice({
      name: 'pad',
      components: [{ name: 'tap', format: 'bool' }],
    });
    a.stop();
    client.publish('/kept', 'double', 7);
    await clock.advance(5_000);
    expect(moves).toEqual([{ previousUrl: 'http://a', url: 'http://c' }]);
    expect(states.at(-1)).toMatchObject({
      status: 'connected',
      clientId: 'client-1',
      resumed: true,
    });
    expect([client.id, client.masterUrl, b.clientIds]).toEqual(['client-1', 'http://c', []]);
    expect(c.holds('client-1')).toMatchObject({
      name: 'ada',
      topics: ['/ubii/masters', '/x'],
      devices: [{ id: device.id, name: 'pad' }],
    });
    expect(c.requests.find((each) => each.client !== undefined)).toMatchObject({
      client: { id: 'client-1', extension: { resumeToken: 'key:client-1' } },
    });
    expect(c.published).toMatchObject([{ topic: '/kept', value: 7 }]);
    c.publish({ topic: '/x', format: 'double', value: 1 });
    await settle();
    expect(values).toEqual([1]);
  });

  it('keeps the new one as its own, and goes on from there when that dies, too', async () => {
    const { a, b, c, client, clock, moves } = await setup({ random: () => 0 });
    a.stop();
    await clock.advance(5_000);
    a.restart();
    await clock.advance(60_000);
    expect(client.masterUrl).toBe('http://c');
    expect(client.otherMasters).toEqual(['http://a', 'http://b']);
    a.stop();
    c.stop();
    await clock.advance(20_000);
    expect(moves.at(-1)).toEqual({ previousUrl: 'http://c', url: 'http://b' });
    expect(b.clientIds).toEqual(['client-1']);
  });

  it('hears of masters that come later, and forgets those that go', async () => {
    const { a, client, clock } = await setup();
    const tell = async (...elements: string[]) => {
      a.publish({ topic: '/ubii/masters', format: 'stringList', value: { elements } });
      await settle();
      return client.otherMasters;
    };
    expect(await tell('http://d')).toEqual(['http://d']);
    expect(await tell()).toEqual([]);
    await tell('http://b');
    a.masters = [];
    a.restart(); // it has not heard of the others yet
    await clock.advance(5_000);
    expect(client.otherMasters).toEqual(['http://b']);
  });

  it('stays with a master that is alone, and subscribes to nothing there', async () => {
    const master = new FakeMaster();
    const { client, clock } = createTestClient(master, { url: 'http://a', others: new Map() });
    await client.connect();
    expect(topicsOf(master)).toEqual(['/services/client/registration']);
    master.stop();
    await clock.advance(60_000);
    master.restart();
    await clock.advance(2_000);
    expect(client.state).toMatchObject({ status: 'connected', clientId: 'client-1' });
  });
});

describe('a client whose master does not answer [CU-81] [CU-82]', () => {
  it('stays with a master that is back within two seconds', async () => {
    const { a, b, c, client, clock } = await setup();
    a.stop();
    await clock.advance(1_900);
    expect([...b.requests, ...c.requests]).toEqual([]);
    a.restart();
    await clock.advance(10_000);
    expect([...b.clientIds, ...c.clientIds]).toEqual([]);
    expect(client.masterUrl).toBe('http://a');
    expect(client.state.status).toBe('connected');
  });

  it('stays when the network was gone and not the master', async () => {
    const { a, b, c, client, clock, states } = await setup();
    for (const master of [a, b, c]) master.stop();
    await clock.advance(60_000);
    expect(states.length).toBeGreaterThan(20);
    for (const master of [b, c, a]) master.isDown = false;
    await clock.advance(5_000);
    expect(client.masterUrl).toBe('http://a');
    expect([...b.clientIds, ...c.clientIds]).toEqual([]);
    expect(new Set([...topicsOf(b), ...topicsOf(c)]).size).toBeLessThanOrEqual(1);
  });

  it('stays with a master that answers and refuses', async () => {
    const { a, b, c, client, clock } = await setup();
    a.restart();
    a.onRequest = () => new ServiceError('resource_exhausted', 'full');
    await clock.advance(60_000);
    expect([...b.requests, ...c.requests]).toEqual([]);
    a.onRequest = undefined;
    await clock.advance(6_000);
    expect(client.state.status).toBe('connected');
  });

  it('leaves a master that takes connections and says nothing', async () => {
    const { a, client, clock } = await setup();
    a.isSilent = true;
    a.drop();
    await clock.advance(15_000);
    expect(client.masterUrl).not.toBe('http://a');
  });

  it('shows no secret to a server that is not of the cluster, whatever it answers [CU-85]', async () => {
    const { a, b, c, client, clock } = await setup();
    a.credential = 'secret';
    a.restart();
    await clock.advance(10_000);
    const shown: unknown[] = [];
    for (const master of [b, c]) {
      master.restart({ hasNewKey: true }); // another installation, which has the address now
      const handle = master.handleServiceRequest.bind(master);
      Object.assign(master, {
        handleServiceRequest: (request: never, bearer: unknown) => {
          shown.push(request, bearer);
          return handle(request);
        },
        openConnection: (query: unknown) => void shown.push(query),
      });
    }
    a.stop();
    await clock.advance(20_000);
    expect(shown.length).toBeGreaterThan(4);
    const told = JSON.stringify(shown);
    expect([told.includes('secret'), told.includes('key:client-1')]).toEqual([false, false]);
    expect(new Set([...topicsOf(b), ...topicsOf(c)])).toEqual(
      new Set(['/services/ubii/master_proof']),
    );
    const nonces = [...b.requests, ...c.requests].map((each) => each.masterProofRequest?.nonce);
    expect(new Set(nonces).size).toBe(nonces.length);
    a.isDown = false;
    await clock.advance(6_000);
    expect([client.masterUrl, client.authorization]).toEqual(['http://a', 'Bearer secret']);
  });
});

describe('a client that goes to another master [CU-83]', () => {
  it('tries the next one when it is refused, and loses nothing by it', async () => {
    const { a, b, c, client, clock } = await setup({ random: () => 0 });
    c.onRequest = ({ client: asked }) =>
      asked === undefined ? undefined : new ServiceError('permission_denied', 'no');
    a.stop();
    await clock.advance(15_000);
    expect(client.masterUrl).toBe('http://b');
    expect(b.clientIds).toEqual(['client-1']);
    expect(topicsOf(c)).toContain('/services/client/registration');
  });

  it('comes back to its own when every other one refuses', async () => {
    const { a, b, c, client, clock, problems } = await setup();
    for (const master of [b, c]) {
      master.onRequest = () => new ServiceError('unauthenticated', 'no');
    }
    await client.subscribe('/x').ready;
    a.stop();
    await clock.advance(30_000);
    a.isDown = false;
    await clock.advance(5_000);
    expect(client.state).toMatchObject({ status: 'connected', clientId: 'client-1' });
    expect(client.masterUrl).toBe('http://a');
    expect(a.holds('client-1').topics).toEqual(['/ubii/masters', '/x']);
    expect(problems).toEqual([]);
  });

  it('leaves a master that registers it as a new client', async () => {
    const { a, b, c, client, clock } = await setup({ random: () => 0 });
    await createTestClient(c).client.connect(); // its first id is another client's
    c.onRequest = ({ client: asked }) => {
      if (asked !== undefined) c.restart({ hasNewKey: true }); // between its proof and the registration
    };
    a.stop();
    await clock.advance(15_000);
    expect([client.id, client.masterUrl]).toEqual(['client-1', 'http://b']);
    expect([b.clientIds, c.clientIds]).toEqual([['client-1'], []]);
    expect(topicsOf(c)).toContain('/services/client/deregistration');
  });

  it('keeps its credential when another master does not take it', async () => {
    const { a, b, c, client, clock } = await setup();
    a.credential = 'secret';
    a.restart();
    await clock.advance(1_000);
    expect(client.authorization).toBe('Bearer secret');
    for (const master of [b, c]) {
      master.onRequest = () =>
        new ServiceError('unauthenticated', 'no', { details: { joinProblem: 2 } });
    }
    a.stop();
    await clock.advance(30_000);
    expect(client.authorization).toBe('Bearer secret');
    expect(client.state.status).toBe('reconnecting');
  });

  it('is who it was when another master, which it leaves again, says who it is', async () => {
    const saved: unknown[] = [];
    const identity = { load: () => undefined, save: (next: unknown) => void saved.push(next) };
    const { a, b, c, client, clock } = await setup({ identity });
    for (const master of [b, c]) {
      master.credential = 'of another master';
      master.openConnection = () => undefined; // it registers the client, and has no socket for it
    }
    a.stop();
    await clock.advance(30_000);
    expect([...b.clientIds, ...c.clientIds]).toContain('client-1');
    a.isDown = false;
    await clock.advance(6_000);
    expect(client.state).toMatchObject({ status: 'connected', clientId: 'client-1' });
    expect(client.authorization).toBeUndefined();
    expect(saved).toEqual([{ clientId: 'client-1', resumeToken: 'key:client-1' }]);
  });

  it('ends calls that the lost master did not answer; later ones wait and go to the new one', async () => {
    const { a, b, c, client, clock } = await setup();
    const answer = () => ({ stringList: { elements: ['/x'] } });
    for (const master of [b, c]) master.services.set('/services/topic_list', answer);
    a.isSilent = true;
    const early = client.call('topicList').catch((error: unknown) => error);
    await settle();
    a.stop();
    await clock.advance(100);
    const late = client.call('topicList');
    await clock.advance(6_000);
    expect(await early).toMatchObject({ name: 'ConnectionError', reason: 'closed' });
    expect(((await early) as Error).message).toContain('The master was lost before it answered');
    expect(await late).toMatchObject({ elements: [] });
  });

  it('deregisters where it is when a program closes it on the way', async () => {
    const { a, b, c, client, clock } = await setup();
    for (const master of [b, c]) {
      master.onRequest = ({ topic }) => {
        master.isSilent = topic === '/services/client/registration';
      };
    }
    a.stop();
    while (![...topicsOf(b), ...topicsOf(c)].includes('/services/client/registration')) {
      await clock.advance(100);
    }
    for (const master of [b, c]) master.isSilent = false;
    const closed = client.close();
    await clock.advance(15_000);
    await closed;
    expect(client.state).toEqual({ status: 'closed', error: undefined });
    expect(clock.timerCount).toBe(0);
  });
});
