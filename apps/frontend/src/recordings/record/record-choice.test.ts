import { fromJson } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import {
  budgetOf,
  choiceOf,
  EVERYTHING,
  isChosen,
  limitError,
  selectionOf,
  type RecordChoice,
} from './record-choice.ts';

const choice: RecordChoice = {
  by: 'all',
  topics: ['/a/b'],
  patterns: '/phone/**, /desk/*\n/x',
  clients: ['Mara'],
  sessions: ['s1'],
  withImages: true,
};

describe('what to record', () => {
  it('is only what the chosen kind selects', () => {
    expect(selectionOf(choice)).toEqual({ withoutImages: false });
    expect(selectionOf({ ...choice, by: 'topics' })).toEqual({
      topics: ['/a/b'],
      patterns: ['/phone/**', '/desk/*', '/x'],
      withoutImages: false,
    });
    expect(selectionOf({ ...choice, by: 'clients', withImages: false })).toEqual({
      clients: ['Mara'],
      withoutImages: true,
    });
  });

  it('is not everything because nothing was chosen', () => {
    expect(isChosen(choice)).toBe(true);
    expect(isChosen({ ...choice, by: 'sessions', sessions: [] })).toBe(false);
    expect(isChosen({ ...choice, by: 'topics', topics: [], patterns: ' ' })).toBe(false);
  });

  it('is read from a selection as it was chosen', () => {
    for (const by of ['all', 'topics', 'clients', 'sessions'] as const) {
      const selection = selectionOf({ ...choice, by, withImages: false });
      const read = choiceOf(fromJson('ubii.extension.RecordingSelection', { ...selection }));
      expect(read).toMatchObject({ by, withImages: false });
      expect(selectionOf(read)).toEqual(selection);
    }
    expect(choiceOf(undefined)).toEqual(EVERYTHING);
  });

  it('has limits, or those of the master', () => {
    expect(budgetOf('10', '')).toEqual({ maxDurationMs: 600_000, maxBytes: 0 });
    expect(limitError('')).toBeUndefined();
    expect(limitError('-3')).toMatch(/above 0/);
    expect(limitError('many')).toMatch(/above 0/);
  });
});
