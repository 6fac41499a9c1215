import { describe, expect, it } from 'vitest';

import type { LoopbackFacts } from '../access/caller-reader.ts';
import { describeReachability } from '../network/reachability.ts';
import { bestPhoneUrl, formatBanner, joinUrl } from './banner.ts';
import { formatEndpoints } from './banner.ts';
import { formatQrCode } from './banner.ts';

const ports = { main: 8080, services: 8102, topicData: 8104 };
const facts = {
  name: 'lab',
  version: '1.2.3',
  dataDir: '/data',
  ports,
  terminal: undefined,
  loopback: { role: 'participant', tellsOwners: true },
  devUrl: undefined,
} as const;

describe('what the terminal shows', () => {
  it('explains how to allow phones while other machines cannot reach the master', () => {
    const reachability = describeReachability('localhost', ports, []);
    const text = formatBanner({ ...facts, reachability });
    expect(text).toContain('http://localhost:8080');
    expect(text).toContain('without --lan off');
    expect(text).toContain('services 8102, topic data 8104');
    expect(bestPhoneUrl(reachability)).toBeUndefined();
  });

  it('shows every address, and gives phones one of a real network', () => {
    const reachability = describeReachability('::', ports, [
      { kind: 'virtual', interfaceName: 'docker0', address: '172.17.0.1' },
      { kind: 'ethernet', interfaceName: 'eth0', address: '10.0.0.2' },
    ]);
    const text = formatBanner({ ...facts, reachability });
    expect(text).toContain('http://10.0.0.2:8080   Ethernet, eth0');
    expect(text).toContain('http://172.17.0.1:8080   virtual network, docker0');
    expect(text).not.toContain('--lan');
    expect(bestPhoneUrl(reachability)).toBe('http://10.0.0.2:8080');
    const join = { token: 'a-token', code: 'K7QF-2MXR' };
    const admin = { token: 'admin-token', code: 'ABCD-EFGH' };
    const withCode = formatBanner({ ...facts, reachability, terminal: { admin, join } });
    expect(withCode).toContain('K7QF-2MXR');
    expect(withCode).not.toContain('a-token');
    expect(withCode).toContain('http://localhost:8080/join#admin-token');
    expect(withCode).toContain('ABCD-EFGH');
    expect(joinUrl('http://10.0.0.2:8080', 'a-token')).toBe('http://10.0.0.2:8080/join#a-token');
  });

  it('[SV-13] shows the address that the operator named', () => {
    const publicUrl = 'https://ubii.example.org';
    const reachability = describeReachability('127.0.0.1', ports, [], { publicUrl });
    const text = formatBanner({ ...facts, reachability });
    expect(text).toContain('https://ubii.example.org   public address\n');
    expect(text).not.toContain('accept the certificate');
    expect(bestPhoneUrl(reachability)).toBe(publicUrl);
  });

  it('says what callers of this machine are [AC-40]', () => {
    const reachability = describeReachability('localhost', ports, []);
    const admin = { token: 'admin-token', code: 'ABCD-EFGH' };
    const textOf = (loopback: LoopbackFacts): string =>
      formatBanner({ ...facts, reachability, loopback, terminal: { admin, join: undefined } });
    expect(textOf({ role: 'participant', tellsOwners: true })).toContain(
      'of your user on this machine are participants',
    );
    expect(textOf({ role: 'participant', tellsOwners: false })).toContain('of all its users');
    expect(textOf({ role: 'none', tellsOwners: true })).toContain('have no access');
    const trusted = textOf({ role: 'admin', tellsOwners: true });
    expect(trusted).toContain('are admins');
    expect(trusted).not.toContain('admin-token');
    expect(trusted).not.toContain('ABCD-EFGH');
  });

  it('tells phones that they have to trust the certificate once', () => {
    const networks = [{ kind: 'wifi', interfaceName: 'wlan0', address: '10.0.0.2' }] as const;
    const reachability = describeReachability('::', ports, networks, { isSecure: true });
    const text = formatBanner({ ...facts, reachability });
    expect(text).toContain('https://10.0.0.2:8080   Wi-Fi, wlan0');
    expect(text).toContain('open http://localhost:8080 and start an example');
    expect(text).toContain('accept the certificate once');
  });

  it('draws a code', async () => {
    expect((await formatQrCode('http://10.0.0.2:8080')).split('\n').length).toBeGreaterThan(10);
  });

  it('gives programs one line', () => {
    expect(formatEndpoints('http://localhost:1', 7)).toBe(
      '{"url":"http://localhost:1","servicesJson":"http://localhost:1/services/json","servicesBinary":"http://localhost:1/services/binary","topicDataWs":"ws://localhost:1/topicdata","pid":7}',
    );
  });
});
