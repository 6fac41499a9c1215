import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { encodeRecord } from '@ubii/proto';
import { RecordingReader, RecordingWriter } from '@ubii/recording';
import { DiskFile } from '@ubii/recording/node';
import { foreignRecording, SAMPLE_HEADER, sampleRecord } from '@ubii/recording/testing';
import { temporaryFolder } from '@ubii/program/testing';
import { expect, it } from 'vitest';
import { exportRecording } from '../src/recordings/export.ts';

/** A recording with a topic of its own, one of another program, and what other programs attached. */
async function mixedFile(path: string): Promise<void> {
  const file = await DiskFile.create(path);
  const writer = await RecordingWriter.create(file, SAMPLE_HEADER);
  await writer.addRecord(sampleRecord('/own', 0));
  const foreign = { schema: undefined, messageEncoding: 'json', metadata: new Map() };
  await writer.addRecord({ ...sampleRecord('/imu', 5), clientId: '', foreign });
  const other = await RecordingReader.open(await foreignRecording());
  for (const part of other.foreignParts()) await writer.addPart(part);
  await writer.end();
  await file.close();
}

it.each([
  ['none', ['/own', '/imu'], 3, ''],
  [
    'recording',
    ['/own'],
    0,
    'Left out: 1 topic with messages of other programs.\n' +
      'Left out: 3 attachments and 2 metadata records of other programs.\n',
  ],
])(
  '[PD-14] an export with personal data "%s" has %j',
  async (personal, topics, attached, words) => {
    const folder = temporaryFolder();
    const path = join(folder, 'mixed.mcap');
    await mixedFile(path);
    const options = { format: 'mcap', topics: [], from: 0, until: Infinity, out: folder } as const;
    let written = '';
    const signal = AbortSignal.timeout(60_000);
    await exportRecording(
      [path],
      { ...options, personal, key: '', help: false, version: false },
      signal,
      (text) => {
        written += text;
      },
    );
    const [target = '', ...more] = written.split(/(?<=\n)/);
    expect(more.join('')).toBe(words);
    const file = await DiskFile.open(target.trim());
    const { summary } = await RecordingReader.open(file);
    expect(summary.topics.map(({ topic }) => topic)).toEqual(topics);
    expect(summary.foreignParts.attachments).toHaveLength(attached);
    await file.close();
  },
);

it('[PD-16] [PD-18] an export says where labelled values stood, and names no file after them', async () => {
  const folder = temporaryFolder();
  const path = join(folder, 'labelled.mcap');
  const file = await DiskFile.create(path);
  const label = { topicPattern: '/person/**', fieldPath: '' };
  const labels = [{ ...label, treatment: 'PERSONAL_TREATMENT_DROP' }];
  const header = { ...SAMPLE_HEADER, personalData: JSON.stringify({ labels }) };
  const writer = await RecordingWriter.create(file, header);
  const text = (topic: string, value: string) => ({
    ...sampleRecord(topic, 0),
    record: encodeRecord({ topic, format: 'string', value }),
  });
  await writer.addRecord(text('/person/name', 'Ada Lovelace'));
  await writer.addRecord(text('/person/name', 'Grace Hopper'));
  await writer.addRecord(text('/person/initials', 'AL'));
  await writer.addRecord(text('/chat', 'ADA  LOVELACE begins'));
  for (const name of ['ada-lovelace', 'grace-hopper'])
    await writer.addRecord(sampleRecord(`/lab/${name}/pulse`, 0));
  await writer.end();
  await file.close();
  const options = { format: 'csv', topics: [], from: 0, until: Infinity, out: folder } as const;
  let written = '';
  await exportRecording(
    [path],
    { ...options, personal: 'recording', key: '', help: false, version: false },
    AbortSignal.timeout(60_000),
    (words) => {
      written += words;
    },
  );
  expect(written.replaceAll(`${folder}/`, '')).toBe(
    'chat.csv\nlab-removed-pulse.csv\n' +
      'Replaced elsewhere: 2 labelled values, in 1 topic, names of topics.\n' +
      'Not searched for elsewhere: 1 labelled value of fewer than 3 characters, or of numbers with fewer than 5 digits.\n',
  );
  const chat = await readFile(join(folder, 'chat.csv'), 'utf8');
  expect(chat).toContain('removed begins');
});
