// @vitest-environment happy-dom
import { expect, it } from 'vitest';
import { atMaster } from './at-master.ts';

it('[CU-92] asks the master that the page is connected to', () => {
  expect(atMaster({}, '/recordings')).toBe('/recordings');
  expect(atMaster({ masterUrl: location.origin }, '/recordings')).toBe('/recordings');
  expect(atMaster({ masterUrl: 'http://10.0.0.6:8080' }, '/recordings')).toBe(
    'http://10.0.0.6:8080/recordings',
  );
});
