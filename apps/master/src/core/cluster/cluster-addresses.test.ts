import { expect, it } from 'vitest';
import { ClusterAddresses } from './cluster-addresses.ts';

it('[CU-90] remembers the newest addresses, and not too many', () => {
  const addresses = new ClusterAddresses();
  addresses.add(['http://first']);
  addresses.add(Array.from({ length: 255 }, (_, i) => `http://m${i}`));
  addresses.add(['http://first', 'http://last']);
  expect(addresses.list()).toHaveLength(256);
  expect(addresses.list()).not.toContain('http://m0');
  expect(addresses.list().slice(-2)).toEqual(['http://first', 'http://last']);
});
