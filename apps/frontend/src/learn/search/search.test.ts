import { expect, it } from 'vitest';
import { searchEntries, type SearchEntry } from './search.ts';

const entry = (title: string, detail: string, kind = 'Lesson'): SearchEntry => ({
  title,
  detail,
  kind,
  to: `/${title}`,
});
const ENTRIES = [
  entry('Publish from Python', 'The Python node on PyPI'),
  entry('vector2', 'Two numbers.', 'Data formats'),
  entry('muxer', 'gathers many topics into a list', 'Glossary'),
  entry('Many phones', 'A muxer gathers one topic of each client'),
];
const find = (query: string): string[] => searchEntries(query, ENTRIES).map(({ title }) => title);

it('finds titles, then details', () => {
  expect(find('muxer')).toEqual(['muxer', 'Many phones']);
  expect(find('numbers')).toEqual(['vector2']);
});

it('takes questions', () => {
  expect(find('How do I publish from Python?')[0]).toBe('Publish from Python');
});

it('finds a title with letters left out', () => {
  expect(find('pblish pythn')).toEqual(['Publish from Python']);
});

it('finds nothing for nothing', () => {
  expect(find('')).toEqual([]);
  expect(find('how do I')).toEqual([]);
  expect(find('zzz')).toEqual([]);
});
