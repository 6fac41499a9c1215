import { describe, expect, it } from 'vitest';

import { parseCluster, parseClusterName } from './cluster-address.ts';

describe('[CU-62] the addresses of a cluster', () => {
  it('are a list of NATS servers', () => {
    expect(parseCluster('nats://a, nats://10.0.0.7:4333,nats://[::1]')).toEqual({
      servers: ['nats://a:4222', 'nats://10.0.0.7:4333', 'nats://[::1]:4222'],
      isEncrypted: false,
    });
    expect(parseCluster('tls://nats.local/').isEncrypted).toBe(true);
  });

  it('may have a user with a password, or a token, which servers do not show', () => {
    const address = parseCluster('nats://ann:s%40cret@a,nats://ann:s%40cret@b');
    expect(address.login).toEqual({ user: 'ann', password: 's@cret' });
    expect(address.servers).toEqual(['nats://a:4222', 'nats://b:4222']);
    expect(parseCluster('nats://t0ken@a').login).toEqual({ token: 't0ken' });
  });

  it.each(['', 'a:4222', 'http://a', 'nats://', 'nats://a/x', 'nats://a?tls=1', 'nats://a:x'])(
    'are not %j',
    (text) => expect(() => parseCluster(text)).toThrow(/addresses of NATS servers/),
  );

  it('agree with one another, and an error shows no secret', () => {
    const wrong = ['nats://a,tls://b', 'nats://u:secret@a,nats://b', 'nats://u:secret@a/x'];
    for (const text of wrong) {
      expect(() => parseCluster(text)).toThrow(/addresses/);
      expect(() => parseCluster(text)).not.toThrow(/secret/);
    }
  });
});

describe('[CU-62] the name of a cluster', () => {
  it('is a word of subjects and stores', () => {
    expect(parseClusterName('lab-2')).toBe('lab-2');
    for (const text of ['', 'A', 'a.b', 'a*', '-a', 'a_b', 'x'.repeat(33)]) {
      expect(() => parseClusterName(text)).toThrow(/lower-case letters/);
    }
  });
});
