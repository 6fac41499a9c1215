import { describe, expect, it } from 'vitest';

import { capitalised, counted, isLongerThan, plural, shortened } from './words.ts';

describe('plural', () => {
  it.each([
    [0, 'sessions'],
    [1, 'session'],
    [2, 'sessions'],
    [21, 'sessions'],
    [1.5, 'sessions'],
  ])('of %d is %s', (number, expected) => {
    expect(plural(number, 'session')).toBe(expected);
  });

  it('takes irregular forms, and parts of sentences', () => {
    expect(plural(2, 'library', 'libraries')).toBe('libraries');
    expect(plural(1, 'module runs', 'modules run')).toBe('module runs');
  });
});

describe('counted', () => {
  it('puts the number before the noun', () => {
    expect(counted(1, 'warning')).toBe('1 warning');
    expect(counted(3, 'library', 'libraries')).toBe('3 libraries');
  });
});

describe('capitalised', () => {
  it('changes the first letter only', () => {
    expect(capitalised('saved and Started')).toBe('Saved and Started');
    expect(capitalised('')).toBe('');
  });
});

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
