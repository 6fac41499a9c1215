import { describe, expect, it } from 'vitest';
import { usableMasters } from './masters.ts';

describe('the masters that a client can use [CU-80]', () => {
  const LAN = 'http://10.0.0.5:8080';

  it.each([
    ['of other machines', LAN, ['http://10.0.0.6:8080/'], ['http://10.0.0.6:8080']],
    ['below a path', LAN, ['https://m.example/ubii/'], ['https://m.example/ubii']],
    [
      'encrypted ones, also as the unencrypted one that it is',
      LAN,
      ['https://10.0.0.6:8080'],
      ['https://10.0.0.6:8080', 'http://10.0.0.6:8080'],
    ],
    ['each once, not its own', LAN, [LAN, 'http://b', 'http://b/'], ['http://b']],
    [
      'no unencrypted one after an encrypted one',
      'https://a',
      ['http://b', 'https://c'],
      ['https://c'],
    ],
    ['not what another machine calls itself', LAN, ['http://localhost:8080', 'http://[::1]:1'], []],
    [
      'not where a machine listens on all its addresses',
      LAN,
      ['http://0.0.0.0:8080', 'http://[::]:8080', 'http://0:8080', 'http://[0:0::0]'],
      [],
    ],
    [
      'not what another machine calls itself in IPv6',
      LAN,
      ['http://[::ffff:127.0.0.1]:1', 'http://[::ffff:127.1.2.3]:1', 'http://[::ffff:0.0.0.0]'],
      [],
    ],
    [
      'where this machine listens on all its addresses, on this machine',
      'http://localhost:1',
      ['http://0.0.0.0:2'],
      ['http://0.0.0.0:2'],
    ],
    [
      'those of this machine, on this machine',
      'http://localhost:1',
      ['http://127.0.0.1:2'],
      ['http://127.0.0.1:2'],
    ],
    ['no other schemes, names and secrets', LAN, ['ftp://b', 'b', '', 'http://me:you@b'], []],
    ['none when its own address is not known', undefined, ['http://b'], []],
    ['none that is longer than an address', LAN, [`http://b/${'x'.repeat(200)}`], []],
  ])('%s', (_, own, told, usable) => {
    expect(usableMasters(told, own)).toEqual(usable);
  });

  it('are not too many', () => {
    const told = Array.from({ length: 100 }, (_, i) => `http://m${i}`);
    expect(usableMasters(told, 'http://a')).toHaveLength(64);
  });
});
