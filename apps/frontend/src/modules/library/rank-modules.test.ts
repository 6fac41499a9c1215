import { fromJson } from '@ubii/proto';
import { moduleLibrary } from '@ubii/modules';
import { describe, expect, it } from 'vitest';
import { firstSentence, moduleFlow, rankModules } from './rank-modules.ts';

const library = moduleLibrary();
const found = (typed: string, ...atHand: readonly ('vector2' | 'double')[]): string[] =>
  rankModules(library, (one) => one, typed.split(' '), new Set(atHand)).map(({ name }) => name);

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
