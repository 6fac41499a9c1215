import { expect, it } from 'vitest';
import { aRun, aStudy } from '../testing/a-study.ts';
import { findStudies, lastRuns, takenPart } from './study-words.ts';

it('studies are found by all words of the search, in any order', () => {
  const all = [aStudy({ name: 'Tap study, pilot' }), aStudy({ name: 'Gestures' })];
  expect(findStudies(all, ' PILOT tap').map(({ name }) => name)).toEqual(['Tap study, pilot']);
  expect(findStudies(all, '')).toHaveLength(2);
  expect(findStudies(all, 'tap gestures')).toEqual([]);
});

it('a study says how many took part', () => {
  expect(takenPart(aStudy())).toBe('No runs yet');
  expect(takenPart(aStudy({ participantCount: 1, runCount: 2 }))).toBe('1 participant, 2 runs');
});

it('the newest run of each study is its last one', () => {
  const runs = [
    aRun([], { studyId: 'a', startedMs: 30 }),
    aRun([], { studyId: 'b', startedMs: 20 }),
    aRun([], { studyId: 'a', startedMs: 10 }),
  ];
  expect([...lastRuns(runs)]).toEqual([
    ['a', 30],
    ['b', 20],
  ]);
});
