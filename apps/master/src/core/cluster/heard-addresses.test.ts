import { expect, it } from 'vitest';
import { HeardAddresses } from './heard-addresses.ts';

it('[CU-90] remembers the newest addresses, and not too many', () => {
  const heard = new HeardAddresses();
  heard.add(['http://first']);
  heard.add(Array.from({ length: 255 }, (_, i) => `http://m${i}`));
  heard.add(['http://first', 'http://last']);
  expect(heard.list()).toHaveLength(256);
  expect(heard.list()).not.toContain('http://m0');
  expect(heard.list().slice(-2)).toEqual(['http://first', 'http://last']);
});
