import type { NetworkInterfaceInfo } from 'node:os';
import { describe, expect, it } from 'vitest';

import { listNetworkAddresses } from './network-addresses.ts';

function address(text: string, internal = false): NetworkInterfaceInfo {
  const base = { address: text, netmask: '', mac: '', internal, cidr: null };
  return text.includes(':') ? { ...base, family: 'IPv6', scopeid: 0 } : { ...base, family: 'IPv4' };
}

const noFiles = () => false;

describe('addresses of this machine', () => {
  it('come with the likeliest for a phone first, and without loopback and link-local ones', () => {
    const found = listNetworkAddresses(
      {
        lo: [address('127.0.0.1', true), address('::1', true)],
        docker0: [address('172.17.0.1')],
        eth0: [address('10.1.1.1'), address('fe80::1'), address('fd00::1')],
        wlp3s0: [address('192.168.1.7')],
        utun3: [address('100.64.0.1')],
        en5: [address('169.254.3.4')],
      },
      noFiles,
    );
    expect(
      found.map(({ kind, interfaceName, address: text }) => [kind, interfaceName, text]),
    ).toEqual([
      ['wifi', 'wlp3s0', '192.168.1.7'],
      ['ethernet', 'eth0', '10.1.1.1'],
      ['virtual', 'docker0', '172.17.0.1'],
      ['virtual', 'utun3', '100.64.0.1'],
    ]);
  });

  it('are IPv6 only where there is nothing else, one of each interface', () => {
    const found = listNetworkAddresses(
      { eth0: [address('fe80::1'), address('fd00::1'), address('fd00::2')] },
      noFiles,
    );
    expect(found.map(({ address: text }) => text)).toEqual(['fd00::1']);
  });

  it('are distinguished by what the system says, where it says something', () => {
    const files = new Set([
      '/sys/class/net',
      '/sys/class/net/mlan0/wireless',
      '/sys/class/net/mlan0/device',
      '/sys/class/net/usb0/device',
    ]);
    const found = listNetworkAddresses(
      {
        mlan0: [address('10.0.0.1')],
        usb0: [address('10.0.0.2')],
        bridge7: [address('10.0.0.3')],
        foo0: [address('10.0.0.4')],
        eth0: [address('10.0.0.5')],
      },
      (path) => files.has(path),
    );
    expect(
      Object.fromEntries(found.map(({ interfaceName, kind }) => [interfaceName, kind])),
    ).toEqual({
      mlan0: 'wifi',
      usb0: 'ethernet',
      eth0: 'ethernet',
      bridge7: 'virtual',
      foo0: 'virtual',
    });
  });

  it.each([
    ['Wi-Fi', 'wifi'],
    ['WLAN', 'wifi'],
    ['Ethernet', 'ethernet'],
    ['Ethernet 2', 'ethernet'],
    ['vEthernet (Default Switch)', 'virtual'],
    ['en0', 'ethernet'],
    ['tailscale0', 'virtual'],
  ])('%s is %s where the system says nothing', (name, kind) => {
    expect(listNetworkAddresses({ [name]: [address('10.0.0.1')] }, noFiles)[0]?.kind).toBe(kind);
  });
});
