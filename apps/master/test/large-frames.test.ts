import { AccessRole, encodeRecord } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { frameOf, TestMaster } from '../src/testing/index.ts';
import { joinAs } from './access-world.ts';

/** More than a slice. */
const MANY = 3_000;

function numbered(topic: string, count: number): Uint8Array {
  return frameOf(
    Array.from({ length: count }, (_, value) => encodeRecord({ topic, format: 'double', value })),
  );
}

async function limitHits(master: TestMaster, limit: string): Promise<number> {
  const { limitList } = await master.call({ topic: '/services/ubii/limit_list' });
  return limitList?.elements.find(({ name }) => name === limit)?.hits ?? 0;
}

async function refusals(master: TestMaster): Promise<number> {
  const { masterStatus } = await master.call({
    topic: '/services/ubii/master_status',
    masterStatusRequest: {},
  });
  return masterStatus!.refused;
}

describe('messages of a player', () => {
  const limits = { frameRecordsOfPlayer: 10, recordsPerSecondOfPlayer: 25 };

  async function setup(role: AccessRole = AccessRole.ACCESS_ROLE_PLAYER, more = {}) {
    const master = new TestMaster({ limits: { ...limits, ...more } });
    const ada = await joinAs(master, role);
    const ben = await master.extension('ben');
    await ben.subscribe({ subscribeTopicRegexp: [`^/${ada.id}/`] });
    const send = (count: number): void => {
      ada.socket.handleTopicData(numbered(`/${ada.id}/a`, count));
      master.clock.endTurnSync();
    };
    return { master, ada, ben, send };
  }

  it('are read up to the limit of records, with one error for the rest [TD-70]', async () => {
    const { master, ada, ben, send } = await setup();
    send(MANY);
    expect(ben.takeRecords()).toHaveLength(10);
    expect(ada.takeErrors()).toMatchObject([
      { code: 'resource_exhausted', message: expect.stringContaining('frameRecordsOfPlayer') },
    ]);
    expect(await refusals(master)).toBe(MANY - 10);
    expect(await limitHits(master, 'frameRecordsOfPlayer')).toBe(1);
  });

  it('are refused beyond the rate of records, with one error for the rest of each [TD-70]', async () => {
    const { master, ada, ben, send } = await setup();
    for (let i = 0; i < 4; i++) send(10);
    expect(ben.takeRecords()).toHaveLength(25);
    expect(ada.takeErrors().map(({ message }) => message)).toEqual([
      expect.stringContaining('25 records per second (limit recordsPerSecondOfPlayer)'),
      expect.stringContaining('recordsPerSecondOfPlayer'),
    ]);
    expect(await refusals(master)).toBe(15);
  });

  it('are refused beyond the limit of bytes [TD-70]', async () => {
    const { ada, ben, send } = await setup(AccessRole.ACCESS_ROLE_PLAYER, {
      frameBytesOfPlayer: 100,
    });
    send(10);
    expect(ben.takeRecords()).toEqual([]);
    expect(ada.takeErrors()).toMatchObject([
      { message: expect.stringContaining('at most 100 bytes (limit frameBytesOfPlayer)') },
    ]);
  });

  it('end at a record with too many fields [TD-12] [TD-70]', async () => {
    const { master, ada, ben } = await setup(AccessRole.ACCESS_ROLE_PLAYER, {
      recordFieldsOfPlayer: 20,
    });
    const list = (count: number): Uint8Array =>
      encodeRecord({
        topic: `/${ada.id}/a`,
        format: 'object2DList',
        value: { elements: Array.from({ length: count }, () => ({})) },
      });
    ada.sendRecords(list(10), list(20));
    master.clock.endTurnSync();
    expect(ben.takeRecords()).toHaveLength(1);
    expect(ada.takeErrors()).toMatchObject([{ message: expect.stringContaining('fields') }]);
  });

  it.each([AccessRole.ACCESS_ROLE_PARTICIPANT, AccessRole.ACCESS_ROLE_ADMIN])(
    'have other limits than those of role %i [TD-70]',
    async (role) => {
      const { ada, ben, send } = await setup(role);
      send(MANY);
      expect(ben.takeRecords()).toHaveLength(MANY);
      expect(ada.takeErrors()).toEqual([]);
    },
  );

  it('have the limits of all clients where those are lower [TD-70]', async () => {
    const { ada, send } = await setup(AccessRole.ACCESS_ROLE_PLAYER, { recordsPerSecond: 3 });
    send(10);
    expect(ada.takeErrors()).toMatchObject([
      { message: expect.stringContaining('3 records per second (limit recordsPerSecond)') },
    ]);
  });

  it('count for a throttle each, with one error for each message [EX-32]', async () => {
    const { master, ada, send } = await setup();
    await master.call({
      topic: '/services/ubii/client_throttle',
      clientThrottleRequest: { targetId: ada.id, recordsPerSecond: 5 },
    });
    ada.takeSent();
    send(10);
    expect(ada.takeErrors()).toHaveLength(1);
    const { clientReport } = await master.call({
      topic: '/services/ubii/client_report',
      clientReportRequest: { clientIds: [ada.id] },
    });
    expect(clientReport?.clients[0]?.throttle?.dropped).toBe(5);
  });
});

describe('a client that sends too many bytes', () => {
  const limits = { publishedBytesPerSecond: 10_000 };

  it('is not read until they are within its rate, and receives an error [TD-70]', async () => {
    const master = new TestMaster({ limits });
    const ada = await master.extension('ada');
    const send = (): void => ada.send('/a', 'string', 'x'.repeat(6_000));
    send();
    expect(ada.connection.isReading).toBe(true);
    send();
    expect(ada.connection.isReading).toBe(false);
    expect(ada.takeErrors()).toMatchObject([
      {
        message: expect.stringContaining('10000 bytes per second (limit publishedBytesPerSecond)'),
      },
    ]);
    expect(await limitHits(master, 'publishedBytesPerSecond')).toBe(1);
    master.clock.advanceSync(2_000);
    expect(ada.connection.isReading).toBe(true);
    expect(await refusals(master)).toBe(0);
  });

  it('pays for many short fields as for long ones [TD-70]', async () => {
    const master = new TestMaster({ limits });
    const ada = await master.extension('ada');
    ada.sendRecords(
      encodeRecord({
        topic: '/a',
        format: 'object2DList',
        value: { elements: Array.from({ length: 1_000 }, () => ({})) },
      }),
    );
    expect(ada.connection.isReading).toBe(false);
  });
});

describe('a client that sends many small messages', () => {
  it('pays for each as for a larger one [TD-70]', async () => {
    const master = new TestMaster({ limits: { publishedBytesPerSecond: 10_000 } });
    const ada = await master.extension('ada');
    for (let i = 0; i < 9; i++) ada.send('/a', 'double', i);
    expect(ada.connection.isReading).toBe(true);
    ada.send('/a', 'double', 9);
    expect(ada.connection.isReading).toBe(false);
    // They were received before: the pause becomes longer.
    for (let i = 0; i < 10; i++) ada.send('/a', 'double', i);
    master.clock.advanceSync(500);
    expect(ada.connection.isReading).toBe(false);
    master.clock.advanceSync(1_000);
    expect(ada.connection.isReading).toBe(true);
  });
});

describe('a large message', () => {
  async function setup() {
    const master = new TestMaster();
    const ada = await master.extension('ada');
    const ben = await master.extension('ben');
    await ben.subscribe({ subscribeTopics: ['/a', '/b', '/c'] });
    return { master, ada, ben };
  }

  it('lets records of others pass, and is read to its end in order [TD-71]', async () => {
    const { master, ada, ben } = await setup();
    ada.socket.handleTopicData(numbered('/a', MANY));
    expect(ada.connection.isReading).toBe(false);
    ben.send('/b', 'double', -1);
    master.clock.endTurnSync();
    expect(ada.connection.isReading).toBe(true);
    const values = ben.takeValues().map(([, value]) => value as number);
    expect(values.indexOf(-1)).toBeLessThan(MANY / 2);
    expect(values.filter((value) => value >= 0)).toEqual(
      Array.from({ length: MANY }, (_, index) => index),
    );
  });

  it('is read before what its client sends after it [TD-15] [TD-71]', async () => {
    const { master, ada, ben } = await setup();
    ada.socket.handleTopicData(numbered('/a', MANY));
    ada.send('/b', 'double', 1);
    ada.socket.handleTopicData(Uint8Array.of(0xff));
    ada.send('/c', 'double', 2);
    master.clock.endTurnSync();
    expect(ben.takeValues().slice(MANY)).toEqual([
      ['/b', 1],
      ['/c', 2],
    ]);
    expect(ada.takeErrors()).toMatchObject([{ code: 'invalid_argument' }]);
  });

  it('is read to its end when its client closes the socket after it [TD-71]', async () => {
    const { master, ada, ben } = await setup();
    ada.socket.handleTopicData(numbered('/a', MANY));
    ada.socket.handleClose('left');
    master.clock.endTurnSync();
    expect(ben.takeRecords()).toHaveLength(MANY);
    const { clientList } = await master.call({ topic: '/services/client/get_list' });
    expect(clientList?.elements.map(({ id }) => id)).not.toContain(ada.id);
  });

  it('ends when another socket takes the place of its socket [TD-7] [TD-71]', async () => {
    const { master, ada, ben } = await setup();
    ada.socket.handleTopicData(numbered('/a', MANY));
    const { connection } = ada;
    ada.open();
    expect(connection.isReading).toBe(true);
    ada.publish('/b', 'double', 1);
    const values = ben.takeValues();
    expect(values.length).toBeLessThan(MANY);
    expect(values.at(-1)).toEqual(['/b', 1]);
    expect(master.log.lines.filter(({ level }) => level === 'error')).toEqual([]);
  });
});
