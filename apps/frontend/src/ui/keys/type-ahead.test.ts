import { describe, expect, it } from 'vitest';
import { TypeAhead } from './type-ahead.ts';

describe('TypeAhead', () => {
  const names = ['alpha', 'beta', 'bravo', 'acceleration', 'battery'];

  it('goes to the next row that begins with the letter', () => {
    const typeAhead = new TypeAhead();
    expect(typeAhead.type('b', names, 0, 0)).toBe(1);
    expect(typeAhead.type('b', names, 1, 100)).toBe(2);
    expect(typeAhead.type('B', names, 2, 200)).toBe(4);
    expect(typeAhead.type('b', names, 4, 300)).toBe(1);
  });

  it('puts letters together into a word until there is a pause', () => {
    const typeAhead = new TypeAhead();
    expect(typeAhead.type('a', names, 1, 0)).toBe(3);
    expect(typeAhead.type('l', names, 3, 100)).toBe(0);
    expect(typeAhead.type('b', names, 0, 2000)).toBe(1);
  });

  it('stays where it is when nothing begins like that', () => {
    expect(new TypeAhead().type('z', names, 0, 0)).toBeUndefined();
    expect(new TypeAhead().type('z', [], -1, 0)).toBeUndefined();
  });
});
