import { connect, createServer, type AddressInfo, type Socket } from 'node:net';
import { endianness } from 'node:os';
import { describe, expect, it, onTestFinished, vi } from 'vitest';
import { PeerOwners, type OwnerSource, type PeerSocket } from './peer-owners.ts';
import { systemTables, type ReadSocketTable, type SocketTable } from './socket-tables.ts';

const HEAD = '  sl  local_address rem_address   st tx_queue rx_queue tr tm->when retrnsmt   uid';
const ESTABLISHED = '01';
const SYN_SENT = '02';
const row = (ends: string, uid: number, inode = 4711, state = ESTABLISHED) =>
  `   1: ${ends} ${state} 00000000:00000000 00:00000000 00000000 ${String(uid).padStart(5)}        0 ${inode} 2 000000003c507864 20 0 0 10 -1`;
const tableOf = (...rows: string[]) => [HEAD, ...rows, ''].join('\n');
/** A connection from port 0xAA74 to port 0xB6EF. */
const peer = (remoteAddress: string, localAddress = remoteAddress) => ({
  remoteAddress,
  remotePort: 0xaa74,
  localAddress,
  localPort: 0xb6ef,
  destroyed: false,
});
/** The rows of both tables, with lines of other sockets before and behind. */
const source = (rows: Partial<Record<SocketTable, string>>, userId = 1000) => {
  const others = { tcp: row('0100007F:0050 0100007F:0051', 7), tcp6: '' };
  const readTable = vi.fn<ReadSocketTable>((table, take) => {
    take(tableOf(others[table], rows[table] ?? '', others[table]));
    return Promise.resolve();
  });
  return { userId, readTable };
};
/** Whose it is, once it was learnt. */
const isOperators = async (from: OwnerSource, socket: PeerSocket) => {
  const owners = new PeerOwners(from);
  await owners.learn(socket);
  return owners.isOperators(socket);
};

const V4 = '0100007F:AA74 0100007F:B6EF';
const V6 = '00000000000000000000000001000000:AA74 00000000000000000000000001000000:B6EF';
const MAPPED = '0000000000000000FFFF00000100007F:AA74 0000000000000000FFFF00000100007F:B6EF';

describe.skipIf(endianness() !== 'LE')('whose program a connection comes from [AC-1]', () => {
  it.each([
    ['127.0.0.1', 'tcp', V4],
    ['::ffff:127.0.0.1', 'tcp', V4],
    ['::ffff:127.0.0.1', 'tcp6', MAPPED],
    ['127.0.0.1', 'tcp6', MAPPED],
    ['::1', 'tcp6', V6],
  ] as const)('is read from the tables of the system: %s in %s', async (address, table, ends) => {
    const of = (uid: number) => isOperators(source({ [table]: row(ends, uid) }), peer(address));
    expect(await Promise.all([1000, 33, 0].map(of))).toEqual([true, false, false]);
  });

  it('is undefined when the other end does not exist or was closed', async () => {
    const other = row(V4.replace('AA74', 'AA75'), 1000);
    const ours = row(V4.split(' ').reverse().join(' '), 1000);
    const tcp = [other, ours].join('\n');
    expect(await isOperators(source({ tcp }), peer('127.0.0.1'))).toBe(false);
    // Orphans are said to be the first user's.
    expect(await isOperators(source({ tcp: row(V4, 0, 0) }, 0), peer('127.0.0.1'))).toBe(false);
    expect(await isOperators(source({}), {})).toBe(false);
  });

  it('is a stranger while a table cannot be read, and before one was', async () => {
    const failing = { userId: 1000, readTable: () => Promise.reject(new Error('EMFILE')) };
    expect(await isOperators(failing, peer('127.0.0.1'))).toBe(false);
    const owners = new PeerOwners(source({ tcp: row(V4, 1000) }));
    expect(owners.isOperators(peer('127.0.0.1'))).toBe(false);
  });

  it('is read once for a connection, and at once for all that ask in a turn', async () => {
    const from = source({ tcp: `${row(V4, 1000)}\n${row(V4.replace('AA74', 'AA75'), 33)}` });
    const owners = new PeerOwners(from);
    const [one, two] = [peer('127.0.0.1'), { ...peer('127.0.0.1'), remotePort: 0xaa75 }];
    await Promise.all([owners.learn(one), owners.learn(two), owners.learn(one)]);
    expect([one, two].map((each) => owners.isOperators(each))).toEqual([true, false]);
    expect([owners.learn(one), from.readTable.mock.calls.length]).toEqual([undefined, 1]);
  });

  it('is found in whatever part of a table it is, and no part behind that is read', async () => {
    const parts = [
      tableOf(row(V4.replace('AA74', 'AA75'), 33)),
      `${row(V4, 1000)}\n`,
      `${row(V4, 33)}\n`,
    ];
    const taken: boolean[] = [];
    const readTable: ReadSocketTable = (_, take) => {
      while (taken.at(-1) !== false) taken.push(take(parts[taken.length]!));
      return Promise.resolve();
    };
    expect(await isOperators({ userId: 1000, readTable }, peer('127.0.0.1'))).toBe(true);
    expect(taken).toEqual([true, false]);
  });

  it('cannot be told where the system says nothing', () => {
    const silent = new PeerOwners({ userId: 1000, readTable: undefined });
    const noUsers = new PeerOwners({ ...source({}), userId: undefined });
    for (const one of [silent, noUsers]) {
      const socket = peer('127.0.0.1');
      expect([one.canTell, one.learn(socket), one.isOperators(socket)]).toEqual([
        false,
        undefined,
        true,
      ]);
    }
  });
});

describe.skipIf(endianness() !== 'LE')('a port that goes to another program [AC-1]', () => {
  it('is looked up in a table that was opened after its connection', async () => {
    const answers: ((table: string) => void)[] = [];
    const readTable: ReadSocketTable = (_, take) =>
      new Promise<void>((resolve) =>
        answers.push((table) => {
          take(table);
          resolve();
        }),
      );
    const owners = new PeerOwners({ userId: 1000, readTable });
    const [before, after] = [peer('127.0.0.1'), peer('127.0.0.1')];
    const learnt = owners.learn(before);
    await vi.waitFor(() => expect(answers).toHaveLength(1));
    // The port changes hands while the table is read that says whose it was.
    const learntLater = owners.learn(after);
    answers[0]!(tableOf(row(V4, 1000)));
    await learnt;
    await vi.waitFor(() => expect(answers).toHaveLength(2));
    answers[1]!(tableOf(row(V4, 33)));
    await learntLater;
    expect([before, after].map((each) => owners.isOperators(each))).toEqual([true, false]);
  });

  it('says nothing of the connection before, which was reset', async () => {
    const socket = peer('127.0.0.1');
    const readTable: ReadSocketTable = (_, take) => {
      // The table has the port of the new program; the reset is handled in the same turn.
      setImmediate(() => (socket.destroyed = true));
      take(tableOf(row(V4, 1000)));
      return Promise.resolve();
    };
    expect(await isOperators({ userId: 1000, readTable }, socket)).toBe(false);
  });

  it('says nothing while the new connection is not established', async () => {
    const from = source({ tcp: row(V4, 1000, 4711, SYN_SENT) });
    expect(await isOperators(from, peer('127.0.0.1'))).toBe(false);
  });
});

describe.skipIf(process.platform !== 'linux')('on Linux', () => {
  it('reads whole lines of a table, and as many as are wanted', async () => {
    const lines: string[] = [];
    const read = async (isEnough: boolean) =>
      systemTables()!('tcp', (text) => {
        lines.push(text);
        return !isEnough;
      });
    await read(true);
    expect(lines).toHaveLength(1);
    await read(false);
    expect(lines.filter((text) => !text.endsWith('\n'))).toEqual([]);
    expect(lines[1]).toMatch(/^ +sl +local_address /);
  });

  it.each(['127.0.0.1', '::1'])('knows a connection of this user over %s [AC-1]', async (host) => {
    const server = createServer();
    await new Promise<void>((resolve) => server.listen(0, '::', resolve));
    const accepted = new Promise<Socket>((resolve) => server.once('connection', resolve));
    const client = connect((server.address() as AddressInfo).port, host);
    onTestFinished(() => {
      client.destroy();
      server.close();
    });
    const real = new PeerOwners();
    await real.learn(await accepted);
    expect([real.canTell, real.isOperators(await accepted)]).toEqual([true, true]);
    (await accepted).destroy();
  });
});
