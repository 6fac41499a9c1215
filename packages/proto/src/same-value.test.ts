import { describe, expect, it } from 'vitest';
import { isSameValue } from './same-value.ts';

describe('isSameValue', () => {
  it.each<[string, unknown, unknown]>([
    ['members in another order', { a: 1, b: 2 }, { b: 2, a: 1 }],
    ['a member that is undefined, and a missing one', { a: 1, b: undefined }, { a: 1 }],
    ['NaN', { a: Number.NaN }, { a: Number.NaN }],
    ['bytes', new Uint8Array([1, 2]), new Uint8Array([1, 2])],
    ['lists in lists', [[1], [2, 3]], [[1], [2, 3]]],
    ['maps', new Map([['a', { b: 1 }]]), new Map([['a', { b: 1 }]])],
  ])('takes %s as equal', (_what, a, b) => {
    expect(isSameValue(a, b)).toBe(true);
    expect(isSameValue(b, a)).toBe(true);
  });

  it.each<[string, unknown, unknown]>([
    ['0 and -0', 0, -0],
    ['undefined and null', { a: undefined }, { a: null }],
    ['a list and an object', [1], { 0: 1 }],
    ['bytes and an object', new Uint8Array([1]), { 0: 1 }],
    ['lists of other lengths', [1], [1, 2]],
    ['lists in another order', [1, 2], [2, 1]],
    ['other members', { a: 1 }, { b: 1 }],
    ['maps with other values', new Map([['a', 1]]), new Map([['a', 2]])],
    ['a map and an object', new Map(), {}],
    ['NaN and null', Number.NaN, null],
  ])('tells %s apart', (_what, a, b) => {
    expect(isSameValue(a, b)).toBe(false);
    expect(isSameValue(b, a)).toBe(false);
  });
});
