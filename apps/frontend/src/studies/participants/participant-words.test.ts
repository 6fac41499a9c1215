import { expect, it } from 'vitest';
import { aRun, aStudy } from '../testing/a-study.ts';
import { consentWords, deletionSentence } from './participant-words.ts';

it('consent has its time, and its version when the text was changed since', () => {
  const timeMs = new Date(2026, 0, 9, 14, 2).getTime();
  const run = aRun([], { consent: { version: 1, timeMs } });
  expect(consentWords(run, aStudy({ consentVersion: 1 }))).toBe('Consented on 9 Jan 2026 14:02.');
  expect(consentWords(run, aStudy({ consentVersion: 2 }))).toContain('to version 1');
  expect(consentWords(aRun([]), aStudy())).toBe('No consent recorded.');
});

it('a deletion names runs, notes, recordings and their size', () => {
  const runs = [aRun([], { notes: [{ text: 'tired' }] }), aRun([])];
  const participant = { code: 'P07', recordingIds: ['a'], sizeBytes: 2_500_000 };
  const sentence = deletionSentence(participant, runs, 'Tap study');
  for (const part of [
    '2 runs',
    '1 note ',
    '1 recording',
    '2.5 MB',
    'P07 in Tap study',
    'cannot be undone',
  ])
    expect(sentence).toContain(part);
  expect(sentence).not.toContain('with consent');
  const consented = [aRun([], { consent: { version: 1 } })];
  expect(deletionSentence(participant, consented, '')).toContain('1 run with consent, ');
});
