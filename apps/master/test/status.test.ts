import { MasterAddressKind, StatusEventKind, StatusProblemSeverity } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TestMaster, type TestMasterOptions } from '../src/testing/index.ts';

async function createAda(options: TestMasterOptions = {}) {
  const master = new TestMaster(options);
  const startedMs = master.clock.nowMs();
  const ada = await master.legacy('ada');
  const status = async (sinceMs = 0) => {
    const reply = await master.call({
      topic: '/services/ubii/master_status',
      masterStatusRequest: { sinceMs },
    });
    return reply.masterStatus!;
  };
  return { master, clock: master.clock, ada, status, startedMs };
}

describe('the status of the master', () => {
  it('has counters and addresses [EX-16]', async () => {
    const addresses = [{ kind: MasterAddressKind.WIFI, interfaceName: 'wlan0', url: 'http://x' }];
    const { master, ada, status, startedMs } = await createAda({ endpoints: { addresses } });
    const ben = await master.register({ name: 'ben' });
    await ada.subscribe({ subscribeTopics: ['/a'] });
    ada.publish('/a', 'double', 1);
    ada.publish('/info/x', 'double', 1);
    const [record] = ada.takeSent();
    const byteLength = record!.kind === 'record' ? record!.record.byteLength : 0;
    master.clock.advanceSync(6_000);
    ada.sendText('PONG');
    expect(await status()).toMatchObject({
      masterId: master.master.id,
      name: 'master-node',
      version: '1.2.3',
      startedMs,
      nowMs: master.clock.nowMs(),
      recordsIn: 1,
      recordsOut: 1,
      bytesIn: byteLength,
      bytesOut: byteLength,
      dropped: 0,
      refused: 1,
      clientsActive: 1,
      clientsInactive: 1,
      clientsUnavailable: 0,
      cpuPercent: 12.5,
      memoryBytes: 80 * 1024 * 1024,
      addresses,
    });
    expect(ben.registered.name).toBe('ben');
  });

  it('has a sample for every two seconds, for ten minutes [EX-17]', async () => {
    const { clock, ada, status, startedMs } = await createAda();
    for (let i = 0; i < 10; i++) ada.publish('/a', 'double', i);
    clock.advanceSync(2_000);
    clock.advanceSync(2_000);
    expect((await status()).samples).toMatchObject([
      { timeMs: startedMs + 2_000, recordsPerSecond: 5 },
      { timeMs: startedMs + 4_000, recordsPerSecond: 0 },
    ]);
    expect((await status(startedMs + 2_000)).samples).toHaveLength(1);
    clock.advanceSync(20 * 60_000);
    const { samples, nowMs } = await status();
    expect(samples).toHaveLength(300);
    expect(samples[0]!.timeMs).toBe(nowMs - 10 * 60_000 + 2_000);
  });

  it('has the last 200 events [EX-17]', async () => {
    const { master, clock, ada, status, startedMs } = await createAda();
    clock.advanceSync(1_000);
    const ben = await master.legacy('ben');
    await ben.call({ topic: '/services/client/deregistration', client: { id: ben.id } });
    ada.drop();
    clock.advanceSync(10_500);
    ada.open();
    expect((await status()).events.map(({ kind, clientId }) => [kind, clientId])).toEqual([
      [StatusEventKind.MASTER_STARTED, ''],
      [StatusEventKind.CLIENT_JOINED, ada.id],
      [StatusEventKind.CLIENT_JOINED, ben.id],
      [StatusEventKind.CLIENT_LEFT, ben.id],
      [StatusEventKind.CLIENT_LOST, ada.id],
      [StatusEventKind.CLIENT_RETURNED, ada.id],
    ]);
    expect((await status(startedMs + 500)).events).toHaveLength(4);
    for (let i = 0; i < 250; i++) await master.register({ name: `client ${i}` });
    const { events } = await status();
    expect(events).toHaveLength(200);
    expect(events.at(-1)).toMatchObject({ text: 'client 249 joined' });
  });

  it('distinguishes clients that left from lost ones [EX-55]', async () => {
    const { master, clock, ada, status } = await createAda();
    const ben = await master.extension('ben');
    const eva = await master.legacy('eva');
    ben.publish('/ben', 'double', 1);
    ben.drop('left');
    eva.drop('left'); // means nothing to existing clients
    ada.drop();
    const listed = async () =>
      (await ada.call({ topic: '/services/client/get_list' })).clientList?.elements.map(
        ({ name }) => name,
      );
    expect(await listed()).toEqual(['ada', 'eva']);
    clock.advanceSync(10_500);
    const { events } = await status();
    expect(events.slice(-3).map(({ text }) => text)).toEqual([
      'ben left',
      expect.stringContaining('lost its connection'),
      expect.stringContaining('lost its connection'),
    ]);
    const topics = await ada.call({ topic: '/services/topic_list' });
    expect(topics.stringList?.elements).not.toContain('/ben');

    // A returning client keeps its identity.
    const again = await master.register({
      id: ben.id,
      name: 'ben',
      extension: { resumeToken: ben.token! },
    });
    expect(again.registered).toMatchObject({ id: ben.id, extension: { resumed: true } });
  });

  it('leaves a client alone whose earlier socket says that it leaves [EX-55]', async () => {
    const { ada, status } = await createAda();
    const earlier = ada.socket;
    ada.open();
    earlier.handleClose('left');
    expect((await status()).clientsActive).toBe(1);
  });

  it('has a problem as long as it is true [EX-18]', async () => {
    const { clock, ada, status } = await createAda();
    expect((await status()).problems).toEqual([]);
    clock.advanceSync(6_000);
    const { problems, nowMs } = await status();
    expect(problems).toMatchObject([
      { code: 'client_silent', severity: StatusProblemSeverity.WARNING, clientId: ada.id },
    ]);
    expect(problems[0]?.sinceMs).toBe(nowMs - 1_000);
    expect(problems[0]?.text).toMatch(
      /nothing for 6 s\. After 10 s its retained values are deleted/,
    );
    clock.advanceSync(100_000);
    expect((await status()).problems[0]?.text).toMatch(
      /nothing for 106 s\. After 10 s its retained values were deleted/,
    );
    ada.sendText('PONG');
    expect((await status()).problems).toEqual([]);
  });

  it('has a problem that is a count for 30 s after it grew [EX-18]', async () => {
    const { clock, ada, status } = await createAda({ limits: { topicsPerClient: 1 } });
    const codes = async () => (await status()).problems.map(({ code }) => code);
    ada.publish('/a', 'double', 1);
    ada.publish('/b', 'double', 1);
    ada.socket.handleTopicData(Uint8Array.of(0x12, 0xff));
    const { problems } = await status();
    expect(problems.map(({ code }) => code)).toEqual(['limit_reached', 'protocol_errors']);
    expect(problems[0]?.text).toContain('topicsPerClient');
    const alive = (durationMs: number) => {
      for (let passed = 0; passed < durationMs; passed += 1_000) {
        clock.advanceSync(1_000);
        ada.sendText('PONG');
      }
    };
    alive(20_000);
    ada.publish('/b', 'double', 1);
    alive(15_000);
    expect(await codes()).toEqual(['limit_reached']);
    alive(20_000);
    expect(await codes()).toEqual([]);
  });

  it('puts the severe problems first [EX-18]', async () => {
    const { clock, ada, status } = await createAda({ limits: { topics: 1 } });
    clock.advanceSync(6_000);
    ada.publish('/a', 'double', 1);
    clock.advanceSync(6_000);
    const { problems } = await status();
    expect(problems.map(({ severity, code }) => [severity, code])).toEqual([
      [StatusProblemSeverity.ERROR, 'limit_reached'],
      [StatusProblemSeverity.WARNING, 'client_silent'],
    ]);
  });

  it('is told to Prometheus in numbers with labels from closed lists', async () => {
    const { master, ada } = await createAda();
    await master.call({ topic: 'no/such/service' });
    ada.publish('/a', 'double', 1);
    ada.publish('/info/a', 'double', 1);
    const metrics = master.master.metrics();
    const names = metrics.map(({ name }) => name);
    expect(new Set(names).size).toBe(names.length);
    for (const { name, help, kind, values } of metrics) {
      expect(name).toMatch(/^ubii_[a-z_]+$/);
      expect(name.endsWith('_total')).toBe(kind === 'counter');
      expect(help).toMatch(/\.$/);
      expect(values.length).toBeGreaterThan(0);
      for (const { labels, value } of values) {
        expect(Number.isFinite(value)).toBe(true);
        expect(Object.keys(labels)).toEqual(Object.keys(values[0]!.labels));
      }
    }
    const value = (name: string, labels = {}) =>
      metrics
        .find((metric) => metric.name === name)
        ?.values.find((one) => JSON.stringify(one.labels) === JSON.stringify(labels))?.value;
    expect(value('ubii_records_received_total')).toBe(1);
    expect(value('ubii_refused_total', { code: 'permission_denied' })).toBe(1);
    expect(value('ubii_service_requests_total', { service: 'unknown' })).toBe(1);
    expect(value('ubii_clients', { state: 'active' })).toBe(1);
    expect(JSON.stringify(metrics)).not.toContain(ada.id);
  });
});
