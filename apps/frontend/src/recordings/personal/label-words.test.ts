import { PersonalTreatment } from '@ubii/proto';
import { expect, it } from 'vitest';
import {
  exampleOf,
  labelText,
  memberOptions,
  nameOfTreatment,
  treatmentOf,
  treatmentsFor,
} from './label-words.ts';

it('offers the members of the formats that topics have', () => {
  const options = memberOptions(new Set(['object2DList']));
  expect(options[0]).toEqual({ value: ' ', text: 'Whole value' });
  expect(options).toContainEqual({
    value: 'object2DList.elements.pose.position',
    text: 'object2DList › pose › position',
  });
  expect(options.some(({ value }) => value.startsWith('double'))).toBe(false);
});

it.each([
  ['', ['pseudonym', 'round', 'drop']],
  ['double', ['round', 'drop']],
  ['string', ['pseudonym', 'drop']],
  ['bool', ['drop']],
])('treatments of "%s" are those that change it', (path, names) => {
  expect(treatmentsFor(path).map(({ value }) => value)).toEqual(names);
});

it('shows what becomes of a value', () => {
  expect(exampleOf('double', 'round', 5)).toEqual(['71.64', '70']);
  expect(exampleOf('object2DList.elements.id', 'pseudonym', 0)).toEqual(['Ada', 'id-7f3a9c']);
  expect(exampleOf('', 'drop', 0)).toEqual(['all records', 'left out']);
});

it('writes a label in words', () => {
  const treatment = PersonalTreatment.PERSONAL_TREATMENT_ROUND;
  const label = { id: '', topicPattern: '/a', fieldPath: 'double', treatment, step: 5, note: '' };
  expect(labelText(label)).toBe('double: round to 5');
  expect(treatmentOf(nameOfTreatment(treatment))).toBe(treatment);
});
