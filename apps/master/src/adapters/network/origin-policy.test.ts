import { describe, expect, it } from 'vitest';

import { OriginPolicy } from './origin-policy.ts';

const loopback = new OriginPolicy({ isOnLan: () => false, host: 'localhost', allowedOrigins: [] });
const onLan = new OriginPolicy({ isOnLan: () => true, host: '::', allowedOrigins: [] });
const configured = new OriginPolicy({
  isOnLan: () => false,
  host: 'localhost',
  allowedOrigins: [
    'https://*.example.org',
    'http://lab.example.net:*',
    'https://one.example.com:8443',
  ],
});

function verdict(policy: OriginPolicy, origin?: string, host = 'localhost:8080') {
  return policy.judge({ host, ...(origin === undefined ? {} : { origin }) }).kind;
}

describe('[SV-8] origins', () => {
  it('lets programs in that send none', () => {
    expect(verdict(loopback)).toBe('same-origin');
    expect(loopback.judge({}).kind).toBe('same-origin');
  });

  it.each([
    ['http://localhost:8080', 'localhost:8080'],
    ['https://localhost', 'localhost'],
    ['http://[::1]:8080', '[::1]:8080'],
    ['http://192.168.1.5:8080', '192.168.1.5:8080'],
    ['http://My-PC.local:8080', 'my-pc.local:8080'],
  ])('knows its own: %s', (origin, host) => {
    expect(verdict(loopback, origin, host)).toBe('same-origin');
  });

  it.each([
    'http://localhost:3000',
    'https://localhost',
    'http://127.0.0.1:8080',
    'http://127.1.2.3',
    'http://[::1]:5173',
    'http://app.localhost:1',
  ])('allows other programs of this machine: %s', (origin) => {
    expect(verdict(loopback, origin)).toBe('allowed');
    expect(verdict(onLan, origin)).toBe('allowed');
  });

  it('allows the addresses of this machine: programs here call themselves by them', () => {
    const policy = new OriginPolicy({
      isOnLan: () => false,
      host: 'localhost',
      allowedOrigins: [],
      isOwnAddress: (address) => address === '192.168.1.5',
    });
    expect(verdict(policy, 'http://192.168.1.5:8080')).toBe('allowed');
    expect(verdict(policy, 'http://192.168.1.6:8080')).toBe('refused');
    expect(verdict(policy, 'http://192.168.1.5.example.org')).toBe('refused');
  });

  it.each([
    'http://192.168.1.5:8080',
    'http://10.0.0.1',
    'https://172.16.3.4:8080',
    'http://[fd00::1]:8080',
  ])('allows private addresses only when listening on the LAN: %s', (origin) => {
    expect(verdict(loopback, origin)).toBe('refused');
    expect(verdict(onLan, origin)).toBe('allowed');
  });

  it.each([
    'https://evil.example',
    'http://localhost.evil.example',
    'http://127.0.0.1.evil.example',
    'http://192.168.1.5.evil.example:8080',
    'http://8.8.8.8',
    'http://172.32.0.1',
    'file://',
    'chrome-extension://localhost',
    '',
  ])('refuses others: %j', (origin) => {
    expect(verdict(loopback, origin)).toBe('refused');
    expect(verdict(onLan, origin)).toBe('refused');
  });

  it.each([
    ['https://a.example.org', 'allowed'],
    ['https://a.b.example.org', 'allowed'],
    ['HTTPS://A.EXAMPLE.ORG', 'allowed'],
    ['https://example.org', 'refused'],
    ['http://a.example.org', 'refused'],
    ['https://a.example.org:444', 'refused'],
    ['https://a.example.org.evil.example', 'refused'],
    ['https://aXexample.org', 'refused'],
    ['http://lab.example.net', 'allowed'],
    ['http://lab.example.net:12345', 'allowed'],
    ['http://lab.example.net:1.evil.example', 'refused'],
    ['https://one.example.com:8443', 'allowed'],
    ['https://one.example.com', 'refused'],
  ])('reads the configured ones: %s is %s', (origin, expected) => {
    expect(verdict(configured, origin)).toBe(expected);
  });

  it('lets everybody in when told to, also pages without a name', () => {
    const open = new OriginPolicy({
      isOnLan: () => false,
      host: 'localhost',
      allowedOrigins: ['*'],
    });
    expect(verdict(open, 'https://evil.example')).toBe('allowed');
    expect(verdict(open, 'null')).toBe('allowed');
  });

  it('asks pages without a name for a token, whatever is configured [AC-46]', () => {
    for (const policy of [loopback, onLan, configured])
      expect(verdict(policy, 'null')).toBe('nameless');
    // The configuration refuses such a name; it has no owner here either.
    const fromFiles = new OriginPolicy({
      isOnLan: () => false,
      host: 'null',
      allowedOrigins: ['null'],
      isOwnAddress: () => true,
    });
    expect(verdict(fromFiles, 'null')).toBe('nameless');
    expect(fromFiles.pageOf({ host: 'localhost:8080', origin: 'null' })).toBe('foreign');
    expect(fromFiles.pageOf({ host: 'null', origin: 'http://null' })).toBe('foreign');
  });
});

describe('[CU-90] pages of the other masters of a cluster', () => {
  const policy = new OriginPolicy({
    isOnLan: () => false,
    host: 'b.example.org',
    allowedOrigins: [],
    clusterOrigins: () => ['https://a.example.org', 'http://198.51.100.7:8080'],
  });

  it.each(['https://a.example.org', 'HTTPS://A.EXAMPLE.ORG', 'http://198.51.100.7:8080'])(
    'may call: %s',
    (origin) => {
      expect(policy.judge({ host: 'b.example.org', origin })).toEqual({ kind: 'allowed', origin });
    },
  );

  it.each([
    'http://a.example.org',
    'https://a.example.org:8443',
    'https://a.example.org.evil.example',
    'https://x.a.example.org',
    'http://198.51.100.7',
    'http://198.51.100.8:8080',
    'null',
  ])('have exactly these origins: not %s', (origin) => {
    expect(verdict(policy, origin, 'b.example.org')).not.toBe('allowed');
  });

  it('have no rights of this machine', () => {
    for (const origin of ['https://a.example.org', 'http://198.51.100.7:8080']) {
      expect(policy.pageOf({ host: 'localhost:8080', origin })).toBe('foreign');
    }
  });

  it('do not make a name one of this master', () => {
    const verdictOfName = policy.judge({ host: 'a.example.org', origin: 'https://a.example.org' });
    expect(verdictOfName.kind).toBe('refused');
  });
});

describe('[SV-13] the address that the operator named', () => {
  const policy = new OriginPolicy({
    isOnLan: () => false,
    host: '127.0.0.1',
    allowedOrigins: [],
    publicUrl: 'https://ubii.example.org:8443',
  });

  it.each([
    ['ubii.example.org:8443', undefined, 'same-origin'],
    ['ubii.example.org:8443', 'https://ubii.example.org:8443', 'same-origin'],
    // A proxy that leaves the port out
    ['ubii.example.org', 'https://ubii.example.org:8443', 'allowed'],
    ['ubii.example.org:8443', 'https://ubii.example.org', 'refused'],
    ['evil.example', undefined, 'refused'],
    ['x.ubii.example.org', undefined, 'refused'],
  ])('is a name of this master: Host %s, Origin %s is %s', (host, origin, kind) => {
    expect(policy.judge({ host, ...(origin && { origin }) }).kind).toBe(kind);
  });

  it('gives its pages no rights of this machine', () => {
    const origin = 'https://ubii.example.org:8443';
    expect(policy.pageOf({ host: 'localhost:8080', origin })).toBe('foreign');
    expect(policy.pageOf({ host: 'ubii.example.org:8443' })).toBe('foreign');
  });
});

describe('whose a page is, on this machine', () => {
  const policy = new OriginPolicy({
    isOnLan: () => true,
    host: 'ubii.example.org',
    allowedOrigins: [
      'https://lab.example',
      'http://lab.example',
      'http://192.168.1.50',
      'http://box.local',
      '*',
    ],
    isOwnAddress: (address) => address === '192.168.1.5' || address === 'fd00::5',
  });
  const page = (headers: Parameters<typeof policy.pageOf>[0]) =>
    policy.pageOf({ host: 'localhost:8080', ...headers });

  it.each([
    [{}, 'own'],
    [{ origin: 'http://localhost:8080' }, 'own'],
    [{ origin: 'http://localhost:8081' }, 'own'],
    [{ origin: 'http://app.localhost:1' }, 'own'],
    [{ origin: 'https://[::1]:3000' }, 'own'],
    [{ host: '192.168.1.5:8080' }, 'own'],
    [{ host: '[fd00::5]:8080', origin: 'http://[fd00::5]:8080' }, 'own'],
    [{ 'sec-fetch-site': 'same-origin' }, 'own'],
    [{ 'sec-fetch-site': 'none' }, 'own'],
    [{ 'sec-fetch-site': 'same-site' }, 'foreign'],
    [{ 'sec-fetch-site': 'cross-site' }, 'foreign'],
    [{ origin: 'https://lab.example' }, 'named'],
    [{ origin: 'http://192.168.1.50' }, 'named'],
    // Configured, but any machine in the network can claim these names.
    [{ origin: 'http://lab.example' }, 'foreign'],
    [{ origin: 'http://box.local' }, 'foreign'],
    [{ origin: 'https://evil.example' }, 'foreign'],
    [{ origin: 'null' }, 'foreign'],
    [{ origin: 'file://' }, 'foreign'],
    // Names of this machine, and one it was told to go by.
    [{ host: 'ubii.example.org' }, 'foreign'],
    [{ host: 'ubii.example.org', origin: 'http://ubii.example.org' }, 'foreign'],
    [{ host: 'box.local', origin: 'http://box.local' }, 'foreign'],
    [{ host: 'lab.example', origin: 'https://lab.example' }, 'foreign'],
    [{ host: '192.168.1.50' }, 'foreign'],
  ])('%j is %s [AC-1] [AC-2] [AC-45]', (headers, kind) => {
    expect(page(headers)).toBe(kind);
  });
});

describe('[SV-8] hostnames, against re-binding', () => {
  it.each([
    'localhost',
    '127.0.0.1:8080',
    '[::1]:8080',
    '8.8.8.8',
    'lab-pc:8080',
    'lab-pc.local',
    'pc.lan',
    'x.home.arpa',
    'localhost.',
  ])('accepts a name that no other machine can own: %s', (host) =>
    expect(verdict(loopback, undefined, host)).toBe('same-origin'),
  );

  it.each(['evil.example', 'evil.example:8080', 'local.evil.example', '127.0.0.1.nip.example'])(
    'refuses a name that an attacker could bind to this machine: %s',
    (host) => {
      expect(verdict(loopback, `http://${host}`, host)).toBe('refused');
      expect(verdict(onLan, undefined, host)).toBe('refused');
    },
  );

  it('accepts the name it listens on, and those of allowed origins', () => {
    const named = new OriginPolicy({
      isOnLan: () => true,
      host: 'ubii.example.org',
      allowedOrigins: [],
    });
    expect(verdict(named, undefined, 'ubii.example.org:8080')).toBe('same-origin');
    expect(verdict(configured, 'https://a.example.org', 'a.example.org')).toBe('same-origin');
    expect(verdict(configured, undefined, 'example.org')).toBe('refused');
  });

  it('says what to do', () => {
    const refused = loopback.judge({ host: 'evil.example' });
    expect(refused).toMatchObject({
      reason: expect.stringContaining('--allowed-origins') as string,
    });
  });
});
