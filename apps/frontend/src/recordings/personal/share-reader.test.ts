import { RecordingReader } from '@ubii/recording';
import { foreignRecording, recorded, sampleRecord } from '@ubii/recording/testing';
import { SHARING_RULES } from '@ubii/recording/personal';
import { expect, it } from 'vitest';
import { shareReader } from './share-reader.ts';

it('a key file that is used again gives the same pseudonyms', async () => {
  const reader = await RecordingReader.open(await recorded([sampleRecord('/ada/a', 0)]));
  const first = await shareReader(reader, { rules: SHARING_RULES, key: undefined });
  const topic = first.topic('/ada/a');
  expect(topic).toMatch(/^\/client-[0-9a-f]{6}\/a$/);
  expect(first.reader.summary.topics).toMatchObject([{ topic }]);
  const second = await shareReader(reader, { rules: SHARING_RULES, key: first.key() });
  expect(second.topic('/ada/a')).toBe(topic);
  await expect(shareReader(reader, { rules: SHARING_RULES, key: '{}' })).rejects.toThrow(
    'This is no key file of pseudonyms.',
  );
});

it('[PD-14] says what other programs attached and a copy leaves out', async () => {
  const choice = { rules: SHARING_RULES, key: undefined };
  const reader = await RecordingReader.open(await foreignRecording());
  const { leftOut } = await shareReader(reader, choice);
  expect(leftOut).toEqual(['Left out: 3 attachments and 2 metadata records of other programs']);
  const own = await RecordingReader.open(await recorded([sampleRecord('/a', 0)]));
  expect((await shareReader(own, choice)).leftOut).toEqual([]);
});
