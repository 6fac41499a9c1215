import { describe, expect, it } from 'vitest';
import { kindOfPeer } from './address-kinds.ts';

describe('kindOfPeer() [EX-25]', () => {
  it.each([
    ['127.0.0.1', 'loopback'],
    ['::1', 'loopback'],
    ['::ffff:127.0.0.1', 'loopback'],
    ['192.168.1.20', 'private'],
    ['::ffff:10.0.0.7', 'private'],
    ['fe80::1%eth0', 'private'],
    ['203.0.113.9', 'public'],
    ['2001:db8::1', 'public'],
    ['pipe', undefined],
    [undefined, undefined],
  ])('takes %s for %s', (address, kind) => {
    expect(kindOfPeer(address)).toBe(kind);
  });
});
