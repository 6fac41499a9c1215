import { afterEach, expect, it, vi } from 'vitest';
import { fetchLicences, filterLicences, licenceCounts, type PackageLicence } from './licences.ts';

const one = (name: string, licence: string, parts: string[]): PackageLicence => ({
  name,
  version: '1.0.0',
  licence,
  author: 'Ada',
  url: '',
  parts,
  text: '',
});
const PACKAGES = [
  one('vue', 'MIT', ['frontend']),
  one('fastify', 'MIT', ['master']),
  one('elkjs', 'EPL-2.0', ['frontend']),
];

afterEach(() => vi.unstubAllGlobals());

it('finds packages by name, licence and part', () => {
  const found = (text: string) => filterLicences(PACKAGES, text).map(({ name }) => name);
  expect(found('mit frontend')).toEqual(['vue']);
  expect(found('epl')).toEqual(['elkjs']);
  expect(found('')).toHaveLength(3);
});

it('counts licences, most first', () => {
  expect(licenceCounts(PACKAGES)).toEqual([
    ['MIT', 2],
    ['EPL-2.0', 1],
  ]);
});

it('says why there is no list', async () => {
  vi.stubGlobal('fetch', async () => new Response('<html>', { status: 200 }));
  await expect(fetchLicences()).rejects.toThrow(/is not built/);
  vi.stubGlobal('fetch', async () => Promise.reject(new TypeError('offline')));
  await expect(fetchLicences()).rejects.toThrow(/does not answer/);
});
