import { fromJson } from '@ubii/proto';
import { moduleLibrary } from '@ubii/modules';
import { describe, expect, it } from 'vitest';
import { findableModule, firstSentence, moduleFlow, rankFound } from './rank-modules.ts';

const library = moduleLibrary();
const found = (typed: string, ...atHand: readonly ('vector2' | 'double')[]): string[] =>
  rankFound(library, findableModule, typed.split(' '), { atHand: new Set(atHand) }).map(
    ({ name }) => name,
  );

it('what was used lately comes before what is as relevant', () => {
  const recent = ['one-euro-filter-vector2', 'clock'];
  const names = rankFound(library, findableModule, ['filter'], { recent }).map(({ name }) => name);
  const inName = names.filter((name) => name.includes('filter'));
  expect(names[0]).toBe('one-euro-filter-vector2');
  expect(names.slice(0, inName.length).toSorted()).toEqual(inName.toSorted());
  expect(rankFound(library, findableModule, [], { recent })[0]!.name).toMatch(/clock|one-euro/);
});

it('favourites come before what was used lately, among what is as relevant', () => {
  const options = { favourites: ['one-euro-filter'], recent: ['one-euro-filter-vector2'] };
  const names = (words: string[]) =>
    rankFound(library, findableModule, words, options).map(({ name }) => name);
  expect(names([]).slice(0, 2)).toEqual(['one-euro-filter', 'one-euro-filter-vector2']);
  expect(names(['clock'])[0]).toBe('clock');
});

describe('modules that answer words', () => {
  it('begin with those that take what is at hand', () => {
    const [first, ...rest] = found('smooth', 'vector2');
    expect(first).toContain('vector2');
    expect(rest.length).toBeGreaterThan(3);
    expect(found('smooth', 'double')[0]).not.toContain('vector');
  });

  it('have the name before the description, and every word somewhere', () => {
    expect(found('low-pass')[0]).toBe('low-pass');
    expect(found('low vector3')[0]).toBe('low-pass-vector3');
    expect(found('low nonsense')).toEqual([]);
  });
});

it('the way through a module is said in formats', () => {
  const module = fromJson('ubii.processing.ProcessingModule', {
    inputs: [{ messageFormat: 'vector2', isRecordList: true }, { messageFormat: 'double' }],
  });
  expect(moduleFlow(module, (format) => format)).toBe('vector2 list +1 → nothing');
});

it('of a description, the first sentence is shown', () => {
  expect(firstSentence('Smooths a value by 1.5. Then more.')).toBe('Smooths a value by 1.5.');
  expect(firstSentence('No full stop')).toBe('No full stop');
});
