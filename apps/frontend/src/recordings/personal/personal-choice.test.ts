import { PersonalTreatment } from '@ubii/proto';
import { expect, it } from 'vitest';
import { allLabels, matchCount, previewOf } from './personal-choice.ts';

const label = (id: string, topicPattern: string) => ({
  id,
  topicPattern,
  fieldPath: '',
  step: 0,
  note: '',
  treatment: PersonalTreatment.PERSONAL_TREATMENT_DROP,
});
const topic = (name: string, clientId: string) => ({
  topic: name,
  clientId,
  clientName: '',
  format: 'double',
  records: 1,
});

it('labels of the master replace those of the file with the same id', () => {
  const labels = allLabels([label('a', '/old'), label('b', '/b')], [label('a', '/new')]);
  expect(labels.map(({ topicPattern }) => topicPattern)).toEqual(['/new', '/b']);
});

it('counts the topics of a pattern', () => {
  expect(matchCount('/heart/**', ['/heart/a', '/heart/b/c', '/other'])).toBe(2);
});

it('says what will be replaced', () => {
  const topics = [topic('/a', 'ada'), topic('/a', 'bob'), topic('/b', 'ada'), topic('/c', '')];
  expect(previewOf(topics, [])).toBe(
    '2 clients will have pseudonyms. No label matches a topic of this recording.',
  );
  expect(previewOf(topics, [label('1', '/a'), label('2', '/?'), label('3', '/none')])).toBe(
    '2 clients will have pseudonyms. 2 labels apply to 3 topics.',
  );
});

it('says that messages of other programs are left out', () => {
  const imu = { ...topic('/imu', ''), format: 'sensor_msgs/msg/Imu' };
  expect(previewOf([topic('/a', 'ada'), imu], [])).toContain(
    '1 topic with messages of other programs is left out',
  );
});
