import { expect, it } from 'vitest';
import { aStudy } from '../testing/a-study.ts';
import { studyErrors } from './study-errors.ts';

it.each([
  [{}, []],
  [{ name: ' ' }, ['name']],
  [{ nameTemplate: '{participant}' }, ['template']],
  [{ repetitions: 0 }, ['repetitions']],
  [{ repetitions: 101 }, ['repetitions']],
  [{ conditions: [] }, ['conditions']],
  [
    { conditions: [{ name: 'A b' }, { name: 'a-B' }, { name: '?' }] },
    ['condition 1', 'condition 2'],
  ],
  [{ devices: [{ name: 'Phone' }, { name: '', tag: 'touch' }] }, ['device 0', 'device 1']],
])('errors of %j are at %j', (json, fields) => {
  expect(Object.keys(studyErrors(aStudy(json)))).toEqual(fields);
});
