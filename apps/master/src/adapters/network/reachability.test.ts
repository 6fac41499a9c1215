import { MasterAddressKind } from '@ubii/proto';
import { describe, expect, it } from 'vitest';

import { describeReachability } from './reachability.ts';

const ports = { main: 8080, services: 8102, topicData: 8104 };
const networks = [
  { kind: 'wifi', interfaceName: 'wlan0', address: '192.168.1.7' },
  { kind: 'ethernet', interfaceName: 'eth0', address: '10.0.0.2' },
  { kind: 'virtual', interfaceName: 'docker0', address: '172.17.0.1' },
] as const;

describe('[SV-10] where a master can be reached', () => {
  it.each(['localhost', '127.0.0.1', '::1'])('nowhere else when it listens on %s', (host) => {
    const { endpoints, networkAddresses } = describeReachability(host, ports, networks);
    expect(networkAddresses).toEqual([]);
    expect(endpoints).toMatchObject({ ipWlan: '', ipEthernet: '' });
    expect(endpoints).toMatchObject({ portServices: 8102, portTopicData: 8104 });
    expect(endpoints.addresses).toMatchObject([{ kind: MasterAddressKind.LOOPBACK }]);
  });

  it.each(['::', '0.0.0.0'])('in all networks when it listens on %s', (host) => {
    const { localUrl, endpoints } = describeReachability(host, ports, networks);
    expect(localUrl).toBe('http://localhost:8080');
    expect(endpoints).toMatchObject({ ipWlan: '192.168.1.7', ipEthernet: '10.0.0.2' });
    expect(endpoints.addresses).toMatchObject([
      { kind: MasterAddressKind.WIFI, interfaceName: 'wlan0', url: 'http://192.168.1.7:8080' },
      { kind: MasterAddressKind.ETHERNET, url: 'http://10.0.0.2:8080' },
      { kind: MasterAddressKind.VIRTUAL, url: 'http://172.17.0.1:8080' },
      { kind: MasterAddressKind.LOOPBACK, url: 'http://localhost:8080' },
    ]);
  });

  it('at one address when it listens there', () => {
    const { localUrl, endpoints } = describeReachability('10.0.0.2', ports, networks);
    expect(localUrl).toBe('http://10.0.0.2:8080');
    expect(endpoints).toMatchObject({ ipWlan: '', ipEthernet: '10.0.0.2' });
    expect(endpoints.addresses).toHaveLength(1);
  });

  it.each(['127.0.0.1', '::'])('[SV-13] at the address that was named, listening on %s', (host) => {
    const publicUrl = 'https://ubii.example.org';
    const { localUrl, networkAddresses, endpoints } = describeReachability(host, ports, networks, {
      publicUrl,
    });
    expect(localUrl).toMatch(/^http:.*:8080$/);
    expect(networkAddresses).toEqual([
      { kind: MasterAddressKind.PUBLIC, interfaceName: '', url: publicUrl },
    ]);
    expect(endpoints.addresses.map(({ url }) => url)).toEqual([publicUrl, localUrl]);
  });

  it('writes IPv6 addresses in brackets and tells existing clients none', () => {
    const ipv6 = [{ kind: 'wifi', interfaceName: 'wlan0', address: 'fd00::1' }] as const;
    const { networkAddresses, endpoints } = describeReachability('::', ports, ipv6);
    expect(networkAddresses[0]?.url).toBe('http://[fd00::1]:8080');
    expect(endpoints.ipWlan).toBe('');
  });
});
