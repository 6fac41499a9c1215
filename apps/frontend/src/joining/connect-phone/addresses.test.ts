import { MasterAddressKind, type MasterAddress } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import {
  addressParts,
  bestAddress,
  joinAddress,
  pageAddress,
  phoneAddresses,
} from './addresses.ts';

const address = (kind: MasterAddress['kind'], url: string): MasterAddress => ({
  kind,
  url,
  interfaceName: 'en0',
});
const loopback = address(MasterAddressKind.LOOPBACK, 'http://localhost:8080');
const wifi = address(MasterAddressKind.WIFI, 'http://192.168.178.42:8080');

describe('phoneAddresses', () => {
  it('offers what another machine can use, in the master’s order', () => {
    expect(phoneAddresses([wifi, loopback], 'http://localhost:8080/')).toEqual([
      { url: wifi.url, network: 'Wi-Fi', interfaceName: 'en0' },
    ]);
    expect(bestAddress([wifi, loopback])).toBe(wifi.url);
  });

  it('offers nothing when the master listens on loopback only: no dead code', () => {
    for (const page of ['http://localhost:8080/', 'http://127.0.0.1:8080/', 'http://[::1]:8080/']) {
      expect(phoneAddresses([loopback], page), page).toEqual([]);
    }
    expect(bestAddress([loopback])).toBeUndefined();
  });

  it('offers the page’s own address when that came over the network', () => {
    expect(phoneAddresses([], 'http://studio.local:8080/topics')).toMatchObject([
      { url: 'http://studio.local:8080' },
    ]);
  });
});

it('an address breaks before its port, and names its scheme when it is not plain HTTP', () => {
  expect(addressParts('http://192.168.178.42:8080')).toEqual({
    host: '192.168.178.42',
    port: ':8080',
  });
  expect(addressParts('https://studio.local')).toEqual({ host: 'https://studio.local', port: '' });
});

it('a page’s address stands on the master’s', () => {
  expect(pageAddress('http://a:1', '/examples/mouse-pointer')).toBe(
    'http://a:1/examples/mouse-pointer',
  );
});

it('virtual networks have their kind by name, and link-local addresses come last', () => {
  const virtual = (interfaceName: string, host: string): MasterAddress => ({
    kind: MasterAddressKind.VIRTUAL,
    interfaceName,
    url: `http://${host}:1`,
  });
  const all = [
    virtual('eth9', '169.254.3.4'),
    wifi,
    virtual('tailscale0', '100.64.0.2'),
    virtual('docker0', '172.17.0.1'),
    virtual('virbr0', '192.168.122.1'),
    virtual('dummy0', '10.9.9.9'),
  ];
  expect(phoneAddresses(all, 'http://localhost:1/').map(({ network }) => network)).toEqual([
    'Wi-Fi',
    'VPN',
    'Container',
    'Virtual machine',
    'Virtual',
    'Link-local',
  ]);
});

it('the token stands in the fragment', () => {
  expect(joinAddress('https://10.0.0.2:8080', 'abc')).toBe('https://10.0.0.2:8080/join#abc');
});
