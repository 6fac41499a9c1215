import { MasterAddressKind } from '@ubii/proto';
import { expect, it } from 'vitest';
import { isOnMaster, needsAuthority, programAddress } from './where-it-runs.ts';

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

it('knows pages of the computer of the master, and addresses with a certificate of its own', () => {
  expect(['http://127.0.0.1:1/', 'http://[::1]:1/', HERE].every(isOnMaster)).toBe(true);
  expect(isOnMaster('https://192.168.1.7:8443/')).toBe(false);
  expect([LAN.url, 'http://localhost:8080'].map(needsAuthority)).toEqual([true, false]);
});
