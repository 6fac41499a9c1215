import { fromJson, type Study, type StudyRun } from '@ubii/proto';

/** Study for tests: two conditions, one phone. */
export function aStudy(json: object = {}): Study {
  return fromJson('ubii.extension.Study', {
    id: 'study',
    name: 'Tap study',
    revision: 1,
    repetitions: 1,
    order: 2,
    conditions: [{ name: 'Left hand' }, { name: 'Right hand' }],
    devices: [{ name: 'Phone', tag: 'touch', count: 1 }],
    ...json,
  });
}

/** Run for tests. @param states of its blocks, as numbers of the schema */
export function aRun(states: readonly number[], json: object = {}): StudyRun {
  return fromJson('ubii.extension.StudyRun', {
    id: 'run',
    studyId: 'study',
    participantCode: 'P07',
    participantNumber: 7,
    visit: '1',
    state: 1,
    revision: 1,
    startedMs: 1_000,
    blocks: states.map((state, index) => ({
      condition: `Condition ${index + 1}`,
      repetition: 1,
      state,
    })),
    ...json,
  });
}
