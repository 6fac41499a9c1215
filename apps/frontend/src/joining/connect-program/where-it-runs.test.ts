import { MasterAddressKind } from '@ubii/proto';
import { expect, it } from 'vitest';
import { needsAuthority, programAddress } from './where-it-runs.ts';

const LAN = {
  url: 'https://192.168.1.7:8443',
  kind: MasterAddressKind.WIFI,
  interfaceName: 'wlan0',
};
const HERE = 'http://localhost:8080/clients/program';

it('gives programs of this computer the address of the page, and others that of the network', () => {
  expect(programAddress('here', [LAN], HERE)).toBe('http://localhost:8080');
  expect(programAddress('elsewhere', [LAN], HERE)).toBe(LAN.url);
  expect(programAddress('elsewhere', [], HERE)).toBeUndefined();
  expect(programAddress('elsewhere', [], 'https://192.168.1.7:8443/x')).toBe(LAN.url);
});

it('knows addresses with a certificate of the master', () => {
  expect([LAN.url, 'http://localhost:8080'].map(needsAuthority)).toEqual([true, false]);
});
