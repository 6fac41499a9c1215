import { expect, it } from 'vitest';

import { describeReachability } from '../network/reachability.ts';
import { announcedAddresses } from './announce.ts';

const PORTS = { main: 8080, services: 8102, topicData: 8104 };

it('is announced in real networks, and never when only this machine can reach it [DI-1]', () => {
  const networks = [
    { kind: 'wifi', interfaceName: 'wlan0', address: '192.168.1.20' },
    { kind: 'ethernet', interfaceName: 'eth0', address: 'fd00::1' },
    { kind: 'ethernet', interfaceName: 'eth1', address: '10.0.0.5' },
    { kind: 'virtual', interfaceName: 'docker0', address: '172.17.0.1' },
  ] as const;
  const addresses = (host: string) =>
    announcedAddresses(describeReachability(host, PORTS, networks, { isSecure: true }));
  expect(addresses('::')).toEqual(['192.168.1.20', '10.0.0.5']);
  expect(addresses('10.0.0.5')).toEqual(['10.0.0.5']);
  expect(addresses('localhost')).toEqual([]);
});
