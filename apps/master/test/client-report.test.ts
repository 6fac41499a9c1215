import { ClientActivityAddressKind, type ClientActivity } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TRUSTED_CALLER } from '../src/index.ts';
import { TestMaster, type TestClient } from '../src/testing/index.ts';

async function createRoom() {
  const master = new TestMaster();
  const ada = await master.extension('ada');
  const ben = await master.extension('ben');
  const report = async (clientIds: string[] = [], subscriptions = false) => {
    const { clientReport } = await master.call({
      topic: '/services/ubii/client_report',
      clientReportRequest: { clientIds, subscriptions },
    });
    return clientReport!;
  };
  const of = async (client: TestClient, subscriptions = false): Promise<ClientActivity> =>
    (await report([client.id], subscriptions)).clients[0]!;
  return { master, ada, ben, report, of };
}

describe('the client report', () => {
  it('reports all clients, or those asked for, and leaves out unknown ids [EX-25]', async () => {
    const { ada, ben, report } = await createRoom();
    const ids = async (asked: string[]) =>
      (await report(asked)).clients.map(({ clientId }) => clientId);
    expect(await ids([])).toEqual([ada.id, ben.id]);
    expect(await ids([ben.id, 'unknown'])).toEqual([ben.id]);
  });

  it('tells who shares an address, and not the address [EX-99]', async () => {
    const { master, of } = await createRoom();
    const groups: string[] = [];
    for (const place of ['192.168.1.50', '192.168.1.50', '192.168.1.51']) {
      const client = await master.register({ name: 'phone' }, { ...TRUSTED_CALLER, place });
      client.open();
      groups.push((await of(client)).addressGroup);
    }
    const [first, second, third] = groups;
    expect(first).not.toBe('');
    expect(second).toBe(first);
    expect(third).not.toBe(first);
  });

  it('has what a client did and what it does a second [EX-25] [EX-26]', async () => {
    const { master, ada, ben, report, of } = await createRoom();
    await ben.subscribe({ subscribeTopics: ['/a'] });
    for (let i = 0; i < 10; i++) ada.publish('/a', 'double', i);
    const before = await of(ada);
    expect(before).toMatchObject({ recordsIn: 10, recordsInPerSecond: 0 });
    expect((await report()).measuredMs).toBe(0);
    master.clock.advanceSync(1_000);
    const adas = await of(ada);
    const bens = await of(ben);
    expect((await report()).measuredMs).toBe(1_000);
    expect(adas).toMatchObject({ recordsInPerSecond: 10, recordsOut: 0, ownedTopics: 1 });
    expect(adas.bytesInPerSecond).toBe(adas.bytesIn);
    expect(bens).toMatchObject({ recordsIn: 0, recordsOut: 10, recordsOutPerSecond: 10 });
    expect(bens.bytesOut).toBe(adas.bytesIn);
    master.clock.advanceSync(1_000);
    expect(await of(ada)).toMatchObject({ recordsIn: 10, recordsInPerSecond: 0, workShare: 0 });
    // Who did nothing for a while is measured since the last second, and not since it did something.
    ada.publish('/a', 'double', 10);
    master.clock.advanceSync(1_000);
    expect(await of(ada)).toMatchObject({ recordsIn: 11, recordsInPerSecond: 1 });
    expect(await of(ben)).toMatchObject({ recordsOut: 11, recordsOutPerSecond: 1 });
  });

  it('has what a client said of its clock [TS-10]', async () => {
    const { master, ada, ben, of } = await createRoom();
    ada.sendText('PING 1');
    expect((await of(ada)).clock).toBeUndefined();
    ada.sendText('PING 2 -3600000.500 0.250 -12.5');
    master.clock.advanceSync(300);
    expect((await of(ada)).clock).toEqual({
      offsetMs: -3600000.5,
      errorMs: 0.25,
      driftPpm: -12.5,
      ageMs: 300,
    });
    expect((await of(ben)).clock).toBeUndefined();
  });

  it('says when it came, when it was heard of, and how far away it is [EX-25]', async () => {
    const { master, ada, of } = await createRoom();
    const startedMs = master.clock.nowMs();
    master.clock.advanceSync(2_700);
    ada.sendText('PONG');
    expect(await of(ada)).toMatchObject({
      firstSeenMs: startedMs,
      lastSeenMs: startedMs + 2_700,
      connected: true,
      connectedMs: startedMs,
      roundTripMs: 200,
      roundTripAgeMs: 0,
    });
    ada.drop();
    expect(await of(ada)).toMatchObject({ connected: false, connectedMs: 0 });
  });

  it('lists subscriptions when asked, patterns first, at most 1000 [EX-25]', async () => {
    const { ada, of } = await createRoom();
    await ada.subscribe({
      subscribeTopics: ['/a'],
      subscribeTopicRegexp: ['^/b/.*'],
      subscribeComponents: [{ name: 'c' }],
      maxRateHz: 20,
    });
    const counts = { topicSubscriptions: 1, patternSubscriptions: 1, componentSubscriptions: 1 };
    expect(await of(ada)).toMatchObject({ ...counts, subscriptions: [] });
    expect(await of(ada, true)).toMatchObject({
      ...counts,
      subscriptions: [
        { pattern: '^/b/.*', maxRateHz: 20 },
        { component: { name: 'c' }, maxRateHz: 20 },
        { topic: '/a', maxRateHz: 20 },
      ],
    });
    await ada.subscribe({ subscribeTopics: Array.from({ length: 1500 }, (_, i) => `/t/${i}`) });
    const many = await of(ada, true);
    expect(many.topicSubscriptions).toBe(1501);
    expect(many.subscriptions).toHaveLength(1000);
  });

  it('says what waits, what was dropped and what was refused [EX-25]', async () => {
    const { ada, ben, of } = await createRoom();
    await ben.subscribe({ subscribeTopics: ['/a'] });
    ben.connection.stall();
    ada.publish('/a', 'double', 1);
    ada.publish('/a', 'double', 2);
    ada.publish('/info/x', 'double', 2);
    ada.socket.handleTopicData(Uint8Array.of(0xff));
    const bens = await of(ben);
    expect(bens).toMatchObject({ queuedRecords: 1, dropped: 1 });
    expect(bens.queuedBytes).toBeGreaterThan(0);
    expect(await of(ada)).toMatchObject({ refused: 1, protocolErrors: 1 });
  });

  it('says which program it is, in bounds, and how near, but not its address [EX-25]', async () => {
    const { master, of } = await createRoom();
    const eve = await master.register({
      name: 'eve',
      extension: { library: `client\n${'x'.repeat(500)}` },
    });
    expect(await of(eve)).toMatchObject({
      userAgent: '',
      addressKind: ClientActivityAddressKind.UNKNOWN,
    });
    eve.open(eve.token, { program: `Phone\u0007 ${'y'.repeat(5000)}`, addressKind: 'private' });
    const eves = await of(eve);
    expect(eves.library).toBe(`client ${'x'.repeat(57)}`);
    expect(eves.userAgent).toHaveLength(256);
    expect(eves.userAgent).toMatch(/^Phone {2}y+$/);
    expect(eves.addressKind).toBe(ClientActivityAddressKind.PRIVATE);
  });

  it('splits the work between publisher and subscriber [EX-27]', async () => {
    const { master, ada, ben, of } = await createRoom();
    await ben.subscribe({ subscribeTopics: ['/a'] });
    for (let i = 0; i < 100; i++) ada.publish('/a', 'bool', true);
    master.clock.advanceSync(1_000);
    const [adas, bens] = [await of(ada), await of(ben)];
    expect(adas.workShare + bens.workShare).toBeCloseTo(1);
    expect(bens.workShare).toBeGreaterThan(0.08);
    expect(bens.workShare).toBeLessThan(0.15);
  });
});
