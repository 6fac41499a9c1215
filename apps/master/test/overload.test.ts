import { StatusEventKind, StatusProblemSeverity, type MasterStatus } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { START_MS } from '../src/core/checks/overload-checks.ts';
import { TestMaster, type TestClient } from '../src/testing/index.ts';
import type { TestMasterOptions } from '../src/testing/test-master.ts';

const BUSY = { cpuPercent: 95, busyPercent: 90, delayMs: 34 };
const CALM = { cpuPercent: 12, busyPercent: 5, delayMs: 1 };

/** A master with two clients, whose start is over. */
async function createRoom(options: TestMasterOptions = {}) {
  const room = await openRoom(options);
  room.pass(START_MS / 1_000, room.ben, 0);
  return room;
}

async function openRoom(options: TestMasterOptions) {
  const master = new TestMaster(options);
  const mara = await master.extension('Mara');
  const ben = await master.extension('Ben');
  const status = async (): Promise<MasterStatus> =>
    (await master.call({ topic: '/services/ubii/master_status', masterStatusRequest: {} }))
      .masterStatus!;
  const codes = async () => (await status()).problems.map(({ code }) => code);
  /** Seconds in each of which this client publishes so much. */
  const pass = (seconds: number, client: TestClient, records: number): void => {
    for (let second = 0; second < seconds; second++) {
      for (let i = 0; i < records; i++) client.send('/a', 'double', i);
      master.clock.endTurnSync();
      master.clock.advanceSync(1_000);
      for (const one of [mara, ben]) one.sendText('PONG');
    }
  };
  const throttleOf = async ({ id }: TestClient) => {
    const { clientReport } = await master.call({
      topic: '/services/ubii/client_report',
      clientReportRequest: { clientIds: [id] },
    });
    return clientReport!.clients[0]!.throttle;
  };
  return { master, mara, ben, status, codes, pass, throttleOf };
}

describe('a busy master', () => {
  it('blames nobody for its own start [EX-45]', async () => {
    const { master, ben, codes, pass } = await openRoom({});
    master.usage.measured = BUSY;
    pass(START_MS / 1_000, ben, 10);
    expect(await codes()).toEqual([]);
    pass(2, ben, 10);
    expect(await codes()).toEqual(['master_busy', 'publisher_noisy']);
  });

  it('says so after three looks in a row, with the cause and what to do [EX-45] [EX-46]', async () => {
    const { master, ben, status, codes, pass } = await createRoom();
    master.usage.measured = BUSY;
    pass(2, ben, 10);
    expect(await codes()).toEqual([]);
    pass(1, ben, 10);
    const { problems, events, busyPercent, delayMs, processors } = await status();
    expect({ busyPercent, delayMs, processors }).toEqual({
      busyPercent: 90,
      delayMs: 34,
      processors: 4,
    });
    expect(problems.find(({ code }) => code === 'master_busy')).toMatchObject({
      severity: StatusProblemSeverity.WARNING,
      text: 'The main thread of the master is busy for 90 % of the time. Its event-loop delay is 34 ms, so values arrive later; 100 % of the forwarding work is caused by Ben.',
      clientId: ben.id,
      remedy: 'Publish or subscribe at a lower rate in that client, or throttle it.',
      sinceMs: master.clock.nowMs(),
    });
    expect(events.filter(({ kind }) => kind === StatusEventKind.OVERLOAD)).toHaveLength(2);
  });

  it('is an error when it is full, and names a client only with a reason [EX-46]', async () => {
    const { master, ben, status, pass } = await createRoom();
    master.usage.measured = { ...BUSY, busyPercent: 99 };
    pass(3, ben, 0);
    expect((await status()).problems).toMatchObject([
      { code: 'master_busy', severity: StatusProblemSeverity.ERROR, clientId: '' },
    ]);
  });

  it('names other programs when it waits for the processor, and no client [EX-46]', async () => {
    const { master, ben, status, pass } = await createRoom();
    master.usage.measured = { ...BUSY, cpuPercent: 8 };
    pass(3, ben, 10);
    expect((await status()).problems).toMatchObject([
      {
        code: 'master_busy',
        text: 'The main thread of the master is busy for 90 % of the time. Its event-loop delay is 34 ms, so values arrive later; it waits most of that time, because other programs use the processor.',
        clientId: '',
        remedy:
          'End other programs on the machine of the master, or run the master on another machine.',
      },
    ]);
  });

  it('is forgotten 30 s after the last look that found it [EX-45] [EX-18]', async () => {
    const { master, ben, codes, pass } = await createRoom();
    master.usage.measured = BUSY;
    pass(3, ben, 0);
    master.usage.measured = CALM;
    pass(30, ben, 0);
    expect(await codes()).toEqual(['master_busy']);
    pass(1, ben, 0);
    expect(await codes()).toEqual([]);
  });

  it('is distinguished from a busy machine [EX-46]', async () => {
    const { master, ben, status, pass } = await createRoom();
    master.usage.measured = { cpuPercent: 350, busyPercent: 20, delayMs: 2 };
    pass(3, ben, 0);
    expect((await status()).problems).toMatchObject([
      {
        code: 'machine_busy',
        text: 'The master and its modules take 88 % of the 4 cores of their machine; no module runs on it.',
      },
    ]);
  });

  it('is one from the share on that its operator says [EX-46]', async () => {
    const { master, ben, codes, pass } = await createRoom({ checks: { busyPercent: 95 } });
    master.usage.measured = BUSY;
    pass(5, ben, 0);
    expect(await codes()).toEqual([]);
  });
});

describe('a noisy publisher', () => {
  it('is named with what it publishes and takes [EX-47]', async () => {
    const { master, ben, status, pass } = await createRoom();
    master.usage.measured = { ...BUSY, busyPercent: 60 };
    pass(3, ben, 50);
    expect((await status()).problems).toMatchObject([
      {
        code: 'publisher_noisy',
        clientId: ben.id,
        text: 'Ben publishes 50 records per second, which take 60 % of the time of the master. All other clients share the rest.',
        remedy: 'Publish less often or smaller records, or throttle the client.',
      },
    ]);
  });

  it('is no client while the master is idle, or when the load is shared [EX-47]', async () => {
    const { master, mara, ben, codes, pass } = await createRoom();
    master.usage.measured = { ...BUSY, busyPercent: 30 };
    pass(4, ben, 50);
    master.usage.measured = { ...BUSY, busyPercent: 70 };
    for (let second = 0; second < 4; second++) {
      for (let i = 0; i < 50; i++) mara.send('/b', 'double', i);
      pass(1, ben, 50);
    }
    expect(await codes()).toEqual([]);
  });

  it('is no client while other programs use the processor [EX-47]', async () => {
    const { master, ben, codes, pass } = await createRoom();
    // Busy by the clock, and yet it hardly computes.
    master.usage.measured = { ...BUSY, busyPercent: 60, cpuPercent: 8 };
    pass(4, ben, 100);
    expect(await codes()).toEqual([]);
  });

  it('is throttled when the policy says so, to what fits, and told [EX-48]', async () => {
    const { master, ben, pass, throttleOf, codes } = await createRoom({
      checks: { checks: 'throttle' },
    });
    master.usage.measured = BUSY;
    pass(3, ben, 90);
    expect(await throttleOf(ben)).toMatchObject({ recordsPerSecond: 40, byPolicy: true });
    expect(ben.takeErrors()).toMatchObject([
      {
        message:
          'This client is throttled to 40 records per second by the policy of the master: its records took more than 40 % of the time of the master. Records above this rate are dropped.',
      },
    ]);
    expect(await codes()).toContain('client_throttled');
    master.usage.measured = { ...BUSY, busyPercent: 40 };
    pass(20, ben, 90);
    expect(await throttleOf(ben)).toMatchObject({ recordsPerSecond: 40 });
  });

  it('is let go when what it wants has fitted for 10 s [EX-48]', async () => {
    const { master, ben, pass, throttleOf } = await createRoom({ checks: { checks: 'throttle' } });
    master.usage.measured = BUSY;
    pass(3, ben, 90);
    master.usage.measured = CALM;
    pass(9, ben, 20);
    expect(await throttleOf(ben)).toBeDefined();
    pass(1, ben, 20);
    expect(await throttleOf(ben)).toBeUndefined();
  });

  it('keeps a throttle that an admin set [EX-48]', async () => {
    const { master, ben, pass, throttleOf } = await createRoom({ checks: { checks: 'throttle' } });
    await master.call({
      topic: '/services/ubii/client_throttle',
      clientThrottleRequest: { targetId: ben.id, recordsPerSecond: 80 },
    });
    master.usage.measured = BUSY;
    pass(5, ben, 60);
    master.usage.measured = CALM;
    pass(20, ben, 1);
    expect(await throttleOf(ben)).toMatchObject({ recordsPerSecond: 80, byPolicy: false });
  });

  it('is only warned of by default, and not even looked for when that is off [EX-48]', async () => {
    const warned = await createRoom();
    warned.master.usage.measured = BUSY;
    warned.pass(5, warned.ben, 90);
    expect(await warned.throttleOf(warned.ben)).toBeUndefined();
    const off = await createRoom({ checks: { checks: 'off' } });
    off.master.usage.measured = BUSY;
    off.pass(5, off.ben, 90);
    expect(await off.codes()).toEqual([]);
  });
});
