import { expect, it } from 'vitest';
import { masterHost, masterProofText } from './master-proof.ts';

it.each([
  ['http://10.0.0.6:8080', '10.0.0.6:8080'],
  ['https://10.0.0.6:8080/path', '10.0.0.6:8080'],
  ['http://M.Example', 'm.example:80'],
  ['https://m.example', 'm.example:443'],
  ['http://[FD00::1]:1', '[fd00::1]:1'],
  ['ftp://m.example', undefined],
  ['http://', undefined],
])('[CU-85] %s is at %s', (url, host) => {
  expect(masterHost(url)).toBe(host);
});

it('[CU-85] says whom, where and when on lines of their own', () => {
  expect(masterProofText({ host: 'a:1', clientId: 'ada', nonce: 'n' })).toBe(
    'ubi-interact master proof 1\na:1\nada\nn',
  );
});
