import { expect, it } from 'vitest';
import { EMPTY_MS, EmptyResults } from './empty-results.ts';

it('is long when all results of a period have nothing', () => {
  const results = new EmptyResults();
  expect(results.isLong).toBe(false);
  for (const atMs of [1000, 1000 + EMPTY_MS - 1]) results.note(true, atMs);
  expect(results.isLong).toBe(false);
  results.note(true, 1000 + EMPTY_MS);
  expect(results.isLong).toBe(true);
});

it('begins again with something that was found, and with another source', () => {
  const results = new EmptyResults();
  const fill = (fromMs: number): void => {
    results.note(true, fromMs);
    results.note(true, fromMs + EMPTY_MS);
  };
  fill(0);
  results.note(false, EMPTY_MS + 1);
  expect(results.isLong).toBe(false);
  fill(20_000);
  expect(results.isLong).toBe(true);
  results.clear();
  results.note(true, 30_000);
  expect(results.isLong).toBe(false);
});

it('does not count the time in which the module gives no result', () => {
  const results = new EmptyResults();
  results.note(true, 0);
  expect(results.isLong).toBe(false);
});
