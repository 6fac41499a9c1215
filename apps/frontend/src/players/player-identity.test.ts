import { describe, expect, it } from 'vitest';
import { playerIdentity } from './player-identity.ts';

describe('playerIdentity()', () => {
  it('depends on the id alone, but for the letter', () => {
    const ada = playerIdentity('9b2f9c1e-3f0a-4d6e-8f77-0d9a3c1b2a11', 'Ada');
    const renamed = playerIdentity('9b2f9c1e-3f0a-4d6e-8f77-0d9a3c1b2a11', 'Countess');
    expect(renamed).toEqual({ ...ada, letter: 'C' });
  });

  it('is the mark of the client where it has one', () => {
    expect(playerIdentity('a', 'Ada', { shape: 3, colour: 2 })).toEqual({
      shape: 'square',
      colour: 'blue',
      letter: 'A',
    });
  });

  it('uses all twelve players', () => {
    const shapes = new Set(
      Array.from({ length: 500 }, (_, i) => playerIdentity(`client-${i}`, '').shape),
    );
    expect(shapes.size).toBe(12);
  });

  it.each([
    ['quiet heron', 'Q'],
    ['  élan', 'É'],
    ['7 of 9', '7'],
    ['…', '?'],
    ['', '?'],
  ])('takes the letter of %j', (name, letter) => {
    expect(playerIdentity('id', name).letter).toBe(letter);
  });
});
