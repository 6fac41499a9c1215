import { expect, it } from 'vitest';
import { accuracyOf } from './accuracy.ts';

const box = (x: number) => ({ x, y: 0, width: 0.2, height: 1 });
const cup = { class: 'cup', box: box(0.1) };
const person = { class: 'person', box: box(0.6) };

it('counts sightings that are right, and objects that were seen', () => {
  const pictures = [
    { seen: [cup, { class: 'cup', box: box(0.7) }], there: [cup, person] },
    { seen: [person], there: [person] },
  ];
  expect(accuracyOf(pictures)).toEqual({ precision: 2 / 3, recall: 2 / 3 });
});

it('counts an object once, of its class and with half of its area', () => {
  expect(accuracyOf([{ seen: [cup, cup], there: [cup] }])).toEqual({ precision: 0.5, recall: 1 });
  const other = { class: 'bowl', box: cup.box };
  const beside = { class: 'cup', box: box(0.2) };
  expect(accuracyOf([{ seen: [other, beside], there: [cup] }])).toEqual({
    precision: 0,
    recall: 0,
  });
});
