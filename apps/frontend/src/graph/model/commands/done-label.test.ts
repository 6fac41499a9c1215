import { expect, it } from 'vitest';
import { doneLabel } from './done-label.ts';

it('says what was done', () => {
  expect(doneLabel('Connect pointer to mirror · position')).toBe(
    'Connected pointer to mirror · position',
  );
  expect(doneLabel('Add clock')).toBe('Added clock');
  expect(doneLabel('Reset step of counter')).toBe('Reset step of counter');
  expect(doneLabel('constructor of all')).toBe('constructor of all');
});
