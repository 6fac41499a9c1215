import { describe, expect, it } from 'vitest';
import { markedParts, placeOfWord, queryWords, searchScore } from './find-words.ts';

describe('words in a text', () => {
  it('are found where words begin, and whole ones count most', () => {
    expect(placeOfWord('low-pass', 'low')).toEqual({ isFirst: true, isWhole: true });
    expect(placeOfWord('passed low-pass', 'pass')).toEqual({ isFirst: false, isWhole: true });
    expect(placeOfWord('low-pass', 'pas')).toEqual({ isFirst: false, isWhole: false });
    expect(placeOfWord('low-pass', 'ass')).toBeUndefined();
  });

  it('are read in lower case', () => {
    expect(queryWords('  Low  PASS ')).toEqual(['low', 'pass']);
  });
});

describe('the parts of a text that match', () => {
  const marked = (text: string, typed: string): string =>
    markedParts(text, queryWords(typed))
      .map(({ text: part, isMatch }) => (isMatch ? `[${part}]` : part))
      .join('');

  it('are every occurrence, joined where they touch', () => {
    expect(marked('Smooths a smooth value', 'smooth')).toBe('[Smooth]s a [smooth] value');
    expect(marked('low-pass', 'low -pa')).toBe('[low-pa]ss');
    expect(marked('low-pass', 'ow lo')).toBe('[low]-pass');
  });

  it('are none without words', () => {
    expect(marked('low-pass', '')).toBe('low-pass');
    expect(marked('', 'low')).toBe('');
  });
});

describe('the order of what is found', () => {
  const score = (typed: string, name: string, aliases: string[] = [], text = ''): number =>
    searchScore({ name, aliases, text }, queryWords(typed));

  it('is name, word in the name, alias, sentence', () => {
    const scores = [
      score('pass', 'pass'),
      score('pass', 'pass-through'),
      score('pass', 'low-pass'),
      score('pass', 'bypass'),
      score('pass', 'filter', ['passing']),
      score('pass', 'filter', [], 'Lets values pass.'),
    ];
    expect(scores).toEqual(scores.toSorted((a, b) => b - a));
    expect(new Set(scores).size).toBe(scores.length);
  });

  it('is 0 when a word is missing', () => {
    expect(score('pass nonsense', 'pass')).toBe(0);
    expect(score('', 'pass')).toBeGreaterThan(0);
  });
});
