import { encodeRecord, type RecordInit } from '@ubii/proto';
import { OutlineReader, RecordingWriter, type RecordingHeader } from '@ubii/recording';
import { MemoryFile, SAMPLE_HEADER, SAMPLE_START_NS } from '@ubii/recording/testing';
import { expect, it } from 'vitest';
import { PREVIEW_PARTS } from './preview-messages.ts';
import { readPreview } from './read-preview.ts';

/** 4 s: a camera at 5 Hz, another one with two pictures, and seven topics, each busier than the one before. */
async function aRecording(header: Partial<RecordingHeader> = {}): Promise<OutlineReader> {
  const file = new MemoryFile();
  const writer = await RecordingWriter.create(file, { ...SAMPLE_HEADER, ...header });
  const put = (ms: number, init: RecordInit): Promise<void> | undefined => {
    const logTimeNs = SAMPLE_START_NS + BigInt(ms) * 1_000_000n;
    const times = { logTimeNs, publishTimeNs: logTimeNs };
    return writer.addRecord({
      topic: init.topic,
      clientId: '',
      record: encodeRecord(init),
      ...times,
    });
  };
  const value = { width: 2, height: 1, data: Uint8Array.of(0, 255) };
  for (let ms = 0; ms <= 4000; ms += 100) {
    if (ms % 200 === 0) await put(ms, { topic: '/cam/face', format: 'image2D', value });
    if (ms % 2000 === 0) await put(ms, { topic: '/cam/desk', format: 'image2D', value });
    for (let i = 1; i <= 7; i++)
      for (let n = 0; n < i; n++) await put(ms, { topic: `/n/${i}`, format: 'double', value: n });
  }
  await writer.end();
  return OutlineReader.open(file);
}

it('shows the busiest topics of a recording, and a picture of its middle', async () => {
  const { preview, pictureRecord } = await readPreview(await aRecording());
  expect(preview).toMatchObject({ durationMs: 4000, topics: 9, hasPicture: true });
  expect(preview.tracks.map(({ topic }) => topic)).toEqual([
    '/n/7',
    '/n/6',
    '/n/5',
    '/n/4',
    '/n/3',
  ]);
  expect(preview.activity).toHaveLength(PREVIEW_PARTS);
  expect(await pictureRecord()).toMatchObject({ topic: '/cam/face', format: 'image2D' });
});

it('shows no picture of a topic that a label of personal data names [PD-7]', async () => {
  const labels = [{ topicPattern: '/cam/face', treatment: 'PERSONAL_TREATMENT_DROP' }];
  const some = await readPreview(await aRecording({ personalData: JSON.stringify({ labels }) }));
  expect(await some.pictureRecord()).toMatchObject({ topic: '/cam/desk' });
  const all = [{ topicPattern: '/cam/**', treatment: 'PERSONAL_TREATMENT_DROP' }];
  const none = await readPreview(
    await aRecording({ personalData: JSON.stringify({ labels: all }) }),
  );
  expect(none.preview.hasPicture).toBe(false);
  expect(await none.pictureRecord()).toBeUndefined();
});
