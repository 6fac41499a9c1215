import { describe, expect, it } from 'vitest';
import { isLongerThan, shortened } from './text-length.ts';

describe('isLongerThan', () => {
  it.each([
    ['a', 1],
    ['é', 2],
    ['€', 3],
    ['🙂', 4],
    ['aé€🙂', 10],
  ])('counts the bytes of %j in UTF-8', (text, byteLength) => {
    expect(isLongerThan(text, byteLength)).toBe(false);
    expect(isLongerThan(text, byteLength - 1)).toBe(true);
  });
});

describe('shortened', () => {
  it('cuts between characters, and ends with an ellipsis', () => {
    expect(shortened('🙂🙂🙂', 3)).toBe('🙂🙂🙂');
    expect(shortened('🙂🙂🙂🙂', 3)).toBe('🙂🙂…');
    expect(shortened('x'.repeat(100_000), 5)).toBe('xxxx…');
  });
});
