import { StudyOrder, type Init, type Study } from '@ubii/proto';

/** A study that works with one phone that has the page Smart device open. */
export const EXAMPLE_STUDY: Init<Study> = {
  name: 'Tap study',
  notes: 'Example. Open Smart device on one phone, then run the study.',
  consentText:
    'You tap on a phone, once with each hand. The times and places of your touches are recorded. ' +
    'Your name is not recorded. You can stop at any time, and have everything deleted afterwards.',
  devices: [{ name: 'Phone', tag: 'touch', count: 1 }],
  conditions: [{ name: 'Left hand' }, { name: 'Right hand' }],
  order: StudyOrder.STUDY_ORDER_BALANCED,
  repetitions: 1,
};

/** A study that has only what it needs. @param taken names of other studies */
export function newStudy(taken: readonly string[]): Init<Study> {
  let number = 1;
  while (taken.includes(`Study ${number}`)) number += 1;
  return {
    name: `Study ${number}`,
    conditions: [{ name: 'Condition 1' }],
    order: StudyOrder.STUDY_ORDER_BALANCED,
    repetitions: 1,
  };
}
