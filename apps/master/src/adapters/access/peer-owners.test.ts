import { connect, createServer, type AddressInfo, type Socket } from 'node:net';
import { endianness } from 'node:os';
import { describe, expect, it, onTestFinished } from 'vitest';
import { PeerOwners } from './peer-owners.ts';

const HEAD = '  sl  local_address rem_address   st tx_queue rx_queue tr tm->when retrnsmt   uid';
const row = (ends: string, uid: number, inode = 4711) =>
  `   1: ${ends} 01 00000000:00000000 00:00000000 00000000 ${String(uid).padStart(5)}        0 ${inode} 2 000000003c507864 20 0 0 10 -1`;
/** A connection from port 0xAA74 to port 0xB6EF. */
const peer = (remoteAddress: string, localAddress = remoteAddress) => ({
  ...{ remoteAddress, remotePort: 0xaa74 },
  ...{ localAddress, localPort: 0xb6ef },
});
const owners = (table: string, userId: number | undefined = 1000) =>
  new PeerOwners({ userId, tables: () => [`${HEAD}\n${table}\n`] });

const V4 = '0100007F:AA74 0100007F:B6EF';
const V6 = '00000000000000000000000001000000:AA74 00000000000000000000000001000000:B6EF';
const MAPPED = '0000000000000000FFFF00000100007F:AA74 0000000000000000FFFF00000100007F:B6EF';

describe.skipIf(endianness() !== 'LE')('whose program a connection comes from [AC-1]', () => {
  it.each([
    ['127.0.0.1', V4],
    ['::ffff:127.0.0.1', V4],
    ['::ffff:127.0.0.1', MAPPED],
    ['::1', V6],
  ])('is read from the tables of the system: %s', (address, ends) => {
    expect(owners(row(ends, 1000)).isOperators(peer(address))).toBe(true);
    expect(owners(row(ends, 33)).isOperators(peer(address))).toBe(false);
    expect(owners(row(ends, 0)).isOperators(peer(address))).toBe(false);
  });

  it('is undefined when the other end does not exist or was closed', () => {
    const other = row(V4.replace('AA74', 'AA75'), 1000);
    const ours = row(V4.split(' ').reverse().join(' '), 1000);
    expect(owners([other, ours].join('\n')).isOperators(peer('127.0.0.1'))).toBe(false);
    // Orphans are said to be the first user's.
    expect(owners(row(V4, 0, 0), 0).isOperators(peer('127.0.0.1'))).toBe(false);
    expect(owners('').isOperators({})).toBe(false);
  });

  it('is asked once for a connection', () => {
    let asked = 0;
    const source = { userId: 1000, tables: () => (asked++, [`${HEAD}\n${row(V4, 1000)}\n`]) };
    const counted = new PeerOwners(source);
    const socket = peer('127.0.0.1');
    expect([counted.isOperators(socket), counted.isOperators(socket), asked]).toEqual([
      true,
      true,
      1,
    ]);
  });

  it('cannot be told where the system says nothing', () => {
    const silent = new PeerOwners({ userId: 1000, tables: () => undefined });
    const noUsers = new PeerOwners({ userId: undefined, tables: () => [''] });
    for (const one of [silent, noUsers]) {
      expect([one.canTell, one.isOperators(peer('127.0.0.1'))]).toEqual([false, true]);
    }
  });
});

describe.skipIf(process.platform !== 'linux')('on Linux', () => {
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
    expect([real.canTell, real.isOperators(await accepted)]).toEqual([true, true]);
    (await accepted).destroy();
  });
});
