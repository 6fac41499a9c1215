import { expect, test } from 'vitest';
import { crowderOf } from './crowding.ts';

/** People by the letter of their address: `a1` and `a2` share one. */
const people = (...keys: string[]) => keys.map((key) => ({ key }));
const addresses = new Map(
  ['a1', 'a2', 'a3', 'b1', 'b2', 'c1'].map((key) => [key, key[0]!] as const),
);

test('the address with most places gives the last one to a new client of another', () => {
  expect(crowderOf(people('a1', 'b1', 'a2', 'a3'), 'c1', addresses)).toBe('a3');
});

test('a place is given first by a person who is away', () => {
  const [first, ...others] = people('a1', 'a2', 'a3');
  const away = { ...first!, awaySinceMs: 1 };
  expect(crowderOf([away, ...others], 'c1', addresses)).toBe('a1');
});

test('an address with one place more gives none: places do not go back and forth', () => {
  expect(crowderOf(people('a1', 'b1'), 'c1', addresses)).toBeUndefined();
  expect(crowderOf(people('a1', 'a2', 'b1'), 'b2', addresses)).toBeUndefined();
  expect(crowderOf(people('a1', 'a2'), 'a3', addresses)).toBeUndefined();
});

test('clients of unknown addresses and bots neither give nor get a place', () => {
  expect(crowderOf(people('a1', 'a2', 'a3'), 'unknown', addresses)).toBeUndefined();
  expect(crowderOf([...people('x', 'y', 'z'), {}, {}], 'c1', addresses)).toBeUndefined();
});
