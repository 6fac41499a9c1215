import { describe, expect, it } from 'vitest';
import { OriginPolicy } from '../network/origin-policy.ts';
import { OwnAddresses } from '../addresses/own-addresses.ts';
import { CallerReader, type LoopbackFacts } from './caller-reader.ts';
import { Networks } from './networks.ts';

const address = (text: string) => ({
  address: text,
  netmask: '',
  mac: '',
  internal: false,
  cidr: null,
  ...(text.includes(':') ? { family: 'IPv6' as const, scopeid: 0 } : { family: 'IPv4' as const }),
});
const own = new OwnAddresses(
  () => 0,
  () => ({ eth0: [address('192.168.1.5'), address('fd00::5'), address('fe80::5')] }),
);
const legacy = new Networks(['10.0.0.0/24', '10.9.0.7', 'fd00:7::/32']);
const proxies = new Networks(['10.0.0.2', '127.0.0.9']);
/** Ports of programs of other users of this machine. */
const STRANGE_PORT = 33;
/** Ports whose programs were looked for. */
const learnt: (number | undefined)[] = [];
const readerWith = (loopback: LoopbackFacts['role']) =>
  new CallerReader({
    policy: new OriginPolicy({
      isOnLan: () => true,
      host: '::',
      allowedOrigins: [],
      isOwnAddress: (text) => own.has(text),
    }),
    loopback,
    isOwnAddress: (text) => own.has(text),
    isLegacyAddress: (text) => legacy.has(text),
    isTrustedProxy: (text) => proxies.has(text),
    owners: {
      learn: ({ remotePort }) => (learnt.push(remotePort), Promise.resolve()),
      isOperators: ({ remotePort }) => remotePort !== STRANGE_PORT,
    },
  });
const reader = readerWith('participant');
const read = (remoteAddress: string | undefined, headers = {}) =>
  reader.read({ socket: { remoteAddress }, headers });

describe('a caller', () => {
  it.each([
    ['127.0.0.1', 'local'],
    ['127.9.9.9', 'local'],
    ['::1', 'local'],
    ['::ffff:127.0.0.1', 'local'],
    ['::FFFF:127.0.0.1', 'local'],
    ['192.168.1.5', 'local'],
    ['::ffff:192.168.1.5', 'local'],
    ['fd00::5', 'local'],
    // A neighbour on another network may have the same one.
    ['fe80::5', 'other'],
    ['fe80::5%eth0', 'other'],
    ['192.168.1.6', 'other'],
    ['::ffff:192.168.1.6', 'other'],
    ['10.0.0.77', 'network'],
    ['::ffff:10.0.0.77', 'network'],
    ['10.0.1.1', 'other'],
    ['10.9.0.7', 'network'],
    ['10.9.0.8', 'other'],
    ['fd00:7::1', 'network'],
    ['0.0.0.0', 'other'],
    ['', 'other'],
    [undefined, 'other'],
  ])('%s is %s [AC-1] [AC-4]', (remoteAddress, standing) => {
    expect(read(remoteAddress).standing).toBe(standing);
  });

  it('with HTTP/1.0 or behind a proxy is not local [AC-1] [AC-4]', () => {
    const socket = { remoteAddress: '127.0.0.1' };
    expect(reader.read({ socket, headers: {}, httpVersion: '1.0' }).standing).toBe('other');
    expect(reader.read({ socket, headers: {}, httpVersion: '1.1' }).standing).toBe('local');
    expect(read('10.0.0.77', { 'x-real-ip': '10.0.0.77' }).standing).toBe('other');
  });

  it('is trusted, admitted or neither, as the operator says [AC-2] [AC-40]', () => {
    const socket = { remoteAddress: '::1' };
    const page = { host: 'localhost', origin: 'http://localhost:8081' };
    const foreign = { host: 'localhost', origin: 'https://evil.example' };
    const kinds = (['admin', 'participant', 'none'] as const).map((loopback) =>
      [{}, page, foreign].map((headers) => {
        const { standing, isHere } = readerWith(loopback).read({ socket, headers });
        return [standing, isHere];
      }),
    );
    expect(kinds).toEqual([
      [
        ['trusted', true],
        ['trusted', true],
        ['other', true],
      ],
      [
        ['local', true],
        ['local', true],
        ['other', true],
      ],
      [
        ['other', true],
        ['other', true],
        ['other', true],
      ],
    ]);
  });

  it('of another user of this machine is a stranger, whatever the operator trusts [AC-1]', () => {
    const socket = { remoteAddress: '127.0.0.1', remotePort: STRANGE_PORT };
    for (const loopback of ['admin', 'participant'] as const) {
      expect(readerWith(loopback).read({ socket, headers: {} })).toMatchObject({
        standing: 'other',
        isHere: false,
      });
    }
  });

  it('with the resume token of a client of this machine is here, whoever runs its program [AC-27]', () => {
    const request = {
      socket: { remoteAddress: '127.0.0.1', remotePort: STRANGE_PORT },
      isProven: true,
    };
    expect(reader.prepare({ ...request, headers: {} })).toBeUndefined();
    expect(reader.read({ ...request, headers: {} })).toMatchObject({
      standing: 'local',
      isHere: true,
    });
    const elsewhere = [
      reader.read({ ...request, headers: { 'x-real-ip': '127.0.0.1' } }),
      reader.read({ ...request, headers: {}, httpVersion: '1.0' }),
      reader.read({ ...request, headers: {}, socket: { remoteAddress: '192.168.1.6' } }),
    ];
    expect(elsewhere.map(({ standing }) => standing)).toEqual(['other', 'other', 'other']);
  });

  it('of this machine alone is looked for before it is read [AC-1]', async () => {
    const prepare = (remoteAddress: string | undefined, rest = {}) =>
      reader.prepare({ socket: { remoteAddress, remotePort: 4711 }, headers: {}, ...rest });
    learnt.length = 0;
    for (const each of ['127.0.0.1', '::1', '192.168.1.5']) await prepare(each);
    expect(learnt).toEqual([4711, 4711, 4711]);
    const others = [
      prepare('10.0.0.77'),
      prepare(undefined),
      prepare('127.0.0.1', { httpVersion: '1.0' }),
      prepare('127.0.0.1', { headers: { 'x-real-ip': '127.0.0.1' } }),
    ];
    expect([others, learnt.length]).toEqual([others.map(() => undefined), 3]);
  });

  it('is the client that a trusted proxy names, and never local [AC-4] [AC-41]', () => {
    const behind = (remoteAddress: string, list: string) => {
      const { standing, place, isHere } = read(remoteAddress, { 'x-forwarded-for': list });
      return [standing, place, isHere];
    };
    expect(behind('10.0.0.2', '203.0.113.7')).toEqual(['other', '203.0.113.7', false]);
    expect(behind('10.0.0.2', '10.9.0.7')).toEqual(['network', '10.9.0.7', false]);
    expect(behind('10.0.0.2', '127.0.0.1')).toEqual(['other', '127.0.0.1', false]);
    expect(behind('10.0.0.2', '192.168.1.5')).toEqual(['other', '192.168.1.5', false]);
    expect(behind('127.0.0.9', '127.0.0.1')).toEqual(['other', '127.0.0.1', false]);
    expect(behind('10.0.0.2', 'nonsense')).toEqual(['other', 'behind 10.0.0.2', false]);
    // Only trusted proxies can name a caller.
    expect(behind('10.0.0.3', '10.9.0.7')).toEqual(['other', 'behind 10.0.0.3', false]);
    expect(behind('127.0.0.1', '10.9.0.7')).toEqual(['other', 'behind 127.0.0.1', false]);
    // A proxy without such a header forwards another caller, too.
    expect(read('10.0.0.2').standing).toBe('other');
    expect(read('127.0.0.9')).toMatchObject({ standing: 'other', isHere: true });
  });

  it('is counted by its address, of IPv6 by its network [AC-17]', () => {
    const placeOf = (remoteAddress: string) => read(remoteAddress).place;
    expect(placeOf('::ffff:10.0.0.1')).toBe('10.0.0.1');
    expect(placeOf('2001:db8:1:2:3:4:5:6')).toBe(placeOf('2001:db8:1:2::9'));
    expect(placeOf('2001:db8::1')).toBe(placeOf('2001:db8::2'));
    expect(placeOf('2001:db8:1:2::9')).not.toBe(placeOf('2001:db8:1:3::9'));
  });

  it.each([
    ['Bearer abc', 'abc'],
    ['bearer   abc ', 'abc'],
    ['Bearer', ''],
    ['Bearer ' + 'x'.repeat(2_000), ''],
    ['Basic abc', undefined],
    ['Bearerabc', undefined],
  ])('shows with %s what follows [AC-3]', (authorization, bearer) => {
    expect(read('127.0.0.1', { authorization }).bearer).toBe(bearer);
  });
});
