import { expect, it } from 'vitest';

import { mib, readProcess, residentOfTree } from './process-figures.ts';

it.runIf(process.platform === 'linux')('reads the figures of a process', () => {
  const { residentBytes, peakBytes, descriptors, threads, cpuMs } = readProcess(process.pid);
  expect(residentBytes).toBeGreaterThan(1024 * 1024);
  expect(peakBytes).toBeGreaterThan(1024 * 1024);
  expect(descriptors).toBeGreaterThan(2);
  expect(threads).toBeGreaterThan(1);
  expect(cpuMs).toBeGreaterThan(0);
  expect(residentOfTree(process.pid)).toBeGreaterThan(1024 * 1024);
});

it('has no figures of a process that does not exist', () => {
  expect(readProcess(-1).residentBytes).toBeUndefined();
  expect(residentOfTree(-1)).toBe(0);
});

it('formats bytes', () => {
  expect(mib(1_572_864)).toBe('1.5 MiB');
  expect(mib(undefined)).toBe('?');
});
