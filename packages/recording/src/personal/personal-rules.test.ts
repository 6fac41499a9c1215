import { PersonalTreatment } from '@ubii/proto';
import { expect, it } from 'vitest';

import { SAMPLE_HEADER } from '../testing/sample-records.ts';
import { labelsOf, parsePersonalRules, SHARING_RULES } from './personal-rules.ts';

const JSON_LABEL = '{"topicPattern":"/a","treatment":"PERSONAL_TREATMENT_ROUND","step":5}';
const LABEL = {
  topicPattern: '/a',
  treatment: PersonalTreatment.PERSONAL_TREATMENT_ROUND,
  step: 5,
};

it('rules that are not given are those of sharing', () => {
  expect(parsePersonalRules('{}')).toEqual(SHARING_RULES);
  const text = `{"time":"shift","labels":[${JSON_LABEL}]}`;
  expect(parsePersonalRules(text)).toMatchObject({
    time: 'shift',
    clients: 'pseudonym',
    labels: [LABEL],
  });
});

it.each([
  ['[]', 'The rules for personal data are no JSON object.'],
  ['{', 'The rules for personal data are no JSON object.'],
  ['{"clients":"drop"}', 'The rules have "clients": "drop", expected pseudonym or keep.'],
  [
    '{"client":"keep"}',
    'The rules have "client": "keep", expected one of clients, notes, markerTexts, time.',
  ],
  ['{"labels":[{"topic":"/a"}]}', 'In the rules, labels[0].topic '],
])('refuses %s', (text, message) => {
  expect(() => parsePersonalRules(text)).toThrow(message);
});

it('the header of a recording has its labels', () => {
  expect(labelsOf(SAMPLE_HEADER)).toEqual([]);
  const personalData = `{"labels":[${JSON_LABEL}]}`;
  expect(labelsOf({ ...SAMPLE_HEADER, personalData })).toMatchObject([LABEL]);
});
