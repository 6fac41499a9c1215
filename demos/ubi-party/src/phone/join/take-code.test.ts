import { expect, test } from 'vitest';
import { takeAddressOf, takeCodeOf, toCode } from './take-code.ts';

test('address of a seat gives its code back', () => {
  const address = takeAddressOf('7KRM', 'https://192.168.0.7:8443/party/play?x=1');
  expect(address).toBe('https://192.168.0.7:8443/party/play#take=7KRM');
  expect(takeCodeOf(new URL(address).hash)).toBe('7KRM');
});

test('address without a code gives none', () => {
  expect([takeCodeOf(''), takeCodeOf('#'), takeCodeOf('#take='), takeCodeOf('#other=1')]).toEqual([
    undefined,
    undefined,
    undefined,
    undefined,
  ]);
});

test('code that is typed is read as it is meant', () => {
  expect(toCode(' 7k-rm ')).toBe('7KRM');
});
