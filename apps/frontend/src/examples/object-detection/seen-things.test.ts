import { expect, it } from 'vitest';
import { seenThings } from './seen-things.ts';

const shape = (name: string, score: number, letter?: string) => ({
  key: `${name} ${score}`,
  name,
  x: 0,
  y: 0,
  score,
  ...(letter && { letter }),
});

it('lists what is above the threshold by score, then the likeliest of what is below', () => {
  const below = [0.15, 0.2, 0.31, 0.25, 0.22, 0.39].map((score) => shape('vase', score));
  const things = seenThings([shape('cup', 0.6), shape('person', 0.9, 'A')], below);
  expect(things.map(({ name, score, isBelow }) => [name, score, isBelow])).toEqual([
    ['person', 0.9, false],
    ['cup', 0.6, false],
    ['vase', 0.39, true],
    ['vase', 0.31, true],
    ['vase', 0.25, true],
    ['vase', 0.22, true],
  ]);
  expect(things[0]!.letter).toBe('A');
  expect(new Set(things.map(({ key }) => key)).size).toBe(things.length);
});
