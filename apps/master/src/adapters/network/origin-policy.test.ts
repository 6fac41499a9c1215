import { describe, expect, it } from 'vitest';

import { OriginPolicy } from './origin-policy.ts';

const loopback = new OriginPolicy({ onLan: false, host: 'localhost', allowedOrigins: [] });
const onLan = new OriginPolicy({ onLan: true, host: '::', allowedOrigins: [] });
const configured = new OriginPolicy({
  onLan: false,
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
      onLan: false,
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
    'null',
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

  it('lets everybody in when told to, also pages without an origin', () => {
    const open = new OriginPolicy({ onLan: false, host: 'localhost', allowedOrigins: ['*'] });
    expect(verdict(open, 'https://evil.example')).toBe('allowed');
    expect(verdict(open, 'null')).toBe('allowed');
    const fromFiles = new OriginPolicy({
      onLan: false,
      host: 'localhost',
      allowedOrigins: ['null'],
    });
    expect(verdict(fromFiles, 'null')).toBe('allowed');
    expect(verdict(fromFiles, 'https://evil.example')).toBe('refused');
  });
});

describe('[SV-8] host names, against re-binding', () => {
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
  ])('accepts what nobody else can own: %s', (host) =>
    expect(verdict(loopback, undefined, host)).toBe('same-origin'),
  );

  it.each(['evil.example', 'evil.example:8080', 'local.evil.example', '127.0.0.1.nip.example'])(
    'refuses what somebody could bind to this machine: %s',
    (host) => {
      expect(verdict(loopback, `http://${host}`, host)).toBe('refused');
      expect(verdict(onLan, undefined, host)).toBe('refused');
    },
  );

  it('accepts the name it listens on, and those of allowed origins', () => {
    const named = new OriginPolicy({ onLan: true, host: 'ubii.example.org', allowedOrigins: [] });
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
