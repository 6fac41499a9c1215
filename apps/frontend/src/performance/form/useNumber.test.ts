// @vitest-environment happy-dom
import { beforeEach, describe, expect, it } from 'vitest';
import { useNumber } from './useNumber.ts';

describe('a number field', () => {
  beforeEach(() => localStorage.clear());
  const field = () => useNumber('rate', { initial: 100, min: 1, max: 1000 });

  it.each([
    ['100', 100],
    [' 7 ', 7],
    ['1e3', 1000],
    ['', undefined],
    ['0', undefined],
    ['1001', undefined],
    ['1.5', undefined],
    ['many', undefined],
  ])('reads "%s" as %s', (text, value) => {
    const number = field();
    number.text = text;
    expect(number.value).toBe(value);
    expect(number.error === undefined).toBe(value !== undefined);
  });

  it('begins with what it should', () => expect(field().value).toBe(100));
});
