import { crc32 } from '@foxglove/crc';
import { McapIndexedReader, McapWriter } from '@mcap/core';
import { expect, test } from 'vitest';
import { RecordingReader } from '../reading/recording-reader.ts';
import { createTreatment } from '../personal/create-treatment.ts';
import { findPeople } from '../personal/known-people.ts';
import { SHARING_RULES } from '../personal/personal-rules.ts';
import { createPseudonymKey, Pseudonyms } from '../personal/pseudonyms.ts';
import { leftOutParts } from '../personal/treatment-report.ts';
import { TreatedReader, treatRecording } from '../personal/treated-reader.ts';
import type { RecordingEvent } from '../records/recording-event.ts';
import type { RecordedTopic } from '../records/recording-summary.ts';
import {
  FOREIGN_PICTURE_BYTES,
  foreignRecording,
  MemoryFile,
  readRecords,
  recorded,
  SAMPLE_START_NS,
  sampleRecord,
} from '../testing/index.ts';
import { cutRecording, type CutOptions } from './cut-recording.ts';

const at = (ms: number): bigint => SAMPLE_START_NS + BigInt(ms) * 1_000_000n;
const startMs = Number(SAMPLE_START_NS / 1_000_000n);

const marker = (id: string, ms: number, more: object = {}): RecordingEvent => ({
  kind: 'marker',
  timeNs: at(ms),
  value: { id, timeMs: startMs + ms, text: id, author: '', authorId: '', kind: 'key', ...more },
});
const session = (ms: number, state: string): RecordingEvent => ({
  kind: 'session',
  timeNs: at(ms),
  value: { id: 's', name: 'Study', state, session: '{}' },
});
const client = (ms: number, name: string): RecordingEvent => ({
  kind: 'client',
  timeNs: at(ms),
  value: { id: 'ada', name, tags: [], state: 'active' },
});
const gap = (fromMs: number, untilMs: number, reason: string): RecordingEvent => ({
  kind: 'gap',
  timeNs: at(untilMs),
  value: { fromMs: startMs + fromMs, untilMs: startMs + untilMs, records: 1, reason },
});

/** `/slow` once at the beginning and by two clients, `/fast` each 10 ms for a second, `/other` as well. */
async function source(): Promise<RecordingReader> {
  const records = [
    sampleRecord('/slow', 0),
    { ...sampleRecord('/slow', 5), clientId: 'ben' },
    ...Array.from({ length: 100 }, (_, i) => [
      sampleRecord('/fast', 10 * i),
      sampleRecord('/other', 10 * i),
    ]).flat(),
  ];
  const events = [
    ...[client(0, 'Ada'), session(0, 'running'), client(450, 'Ada B'), session(450, 'paused')],
    ...[marker('early', 100), marker('within', 450), marker('removed', 460)],
    ...[marker('removed', 460, { isRemoved: true }), marker('moved in', 900)],
    ...[marker('moved in', 480), gap(100, 200, 'early'), gap(300, 410, 'reaching')],
    session(800, 'stopped'),
  ];
  return RecordingReader.open(await recorded(records, events));
}

async function cut(options: CutOptions) {
  const reader = await source();
  const file = new MemoryFile();
  await cutRecording(reader, file, options);
  const result = await RecordingReader.open(file);
  return { reader, result, records: await readRecords(result) };
}

test('a cut has the records of the span bit for bit, and values from before at its beginning', async () => {
  const span = { fromNs: at(400), untilNs: at(500) };
  const { reader, records } = await cut({ ...span, topics: ['/fast', '/slow'] });
  const expected = await readRecords(reader, { ...span, topics: ['/fast'] });
  expect(records.filter(({ logTimeNs }) => logTimeNs > at(400))).toEqual(expected.slice(1));
  const first = records.filter(({ logTimeNs }) => logTimeNs === at(400));
  expect(
    first.map(({ topic, clientId, publishTimeNs }) => [topic, clientId, publishTimeNs]),
  ).toEqual([
    ['/slow', 'ada', at(0)],
    ['/slow', 'ben', at(5)],
    ['/fast', 'ada', at(390)],
    ['/fast', 'ada', at(400)],
  ]);
});

test('a cut has the markers, gaps, sessions and clients of the span', async () => {
  const { result } = await cut({ fromNs: at(400), untilNs: at(500) });
  expect(result.summary).toMatchObject({ name: 'Tuesday', startNs: at(400), endNs: at(500) });
  expect(result.summary.markers.map(({ id }) => id)).toEqual(['within', 'moved in']);
  expect(result.summary.gaps.map(({ reason }) => reason)).toEqual(['reaching']);
  expect((await result.sessionsAt(at(400))).get('s')?.state).toBe('running');
  expect((await result.sessionsAt(at(500))).get('s')?.state).toBe('paused');
  // The name that the client had when the topic began.
  const fast = result.summary.topics.find(({ topic }) => topic === '/fast');
  expect(fast?.clientName).toBe('Ada');
});

test('a cut of everything holds what the recording holds, under another name', async () => {
  const { reader, result, records } = await cut({ header: { name: 'Copy' } });
  const { topics: _, ...summary } = reader.summary;
  expect(result.summary).toMatchObject({ ...summary, name: 'Copy' });
  expect(records).toEqual(await readRecords(reader));
});

test('a cut that is cancelled ends with the reason', async () => {
  const reader = await source();
  const signal = AbortSignal.abort(new Error('cancelled'));
  await expect(cutRecording(reader, new MemoryFile(), { signal })).rejects.toThrow('cancelled');
});

test('a cut without records is refused', async () => {
  const options = { topics: ['/none'] };
  await expect(cutRecording(await source(), new MemoryFile(), options)).rejects.toThrow(
    'There are no records of these topics in this span.',
  );
});

/** `/imu` with a schema, twice, and `/plain` without one. */
async function foreignFile(): Promise<MemoryFile> {
  const file = new MemoryFile();
  const writer = new McapWriter({ writable: file });
  await writer.start({ profile: 'ros2', library: 'other' });
  const imu = await writer.registerSchema({
    name: 'sensor_msgs/msg/Imu',
    encoding: 'ros2msg',
    data: Uint8Array.of(7, 8),
  });
  const channelOf = (topic: string, schemaId: number, messageEncoding: string) =>
    writer.registerChannel({
      schemaId,
      topic,
      messageEncoding,
      metadata: new Map([['offered_qos', topic]]),
    });
  const channels = [await channelOf('/imu', imu, 'cdr'), await channelOf('/plain', 0, 'json')];
  for (const [sequence, ms] of [0, 10, 20].entries()) {
    const times = { logTime: at(ms), publishTime: at(ms) - 5n };
    const channelId = channels[sequence % 2]!;
    await writer.addMessage({ channelId, sequence, data: Uint8Array.of(ms, 255), ...times });
  }
  await writer.end();
  return file;
}

test('a cut has messages of other programs bit for bit, with schema and metadata', async () => {
  const reader = await RecordingReader.open(await foreignFile());
  const file = new MemoryFile();
  await cutRecording(reader, file, { fromNs: at(5), untilNs: at(20) });
  const result = await RecordingReader.open(file);
  const describe = ({ topic, isRaw, schemaName, messageEncoding }: RecordedTopic) => ({
    topic,
    isRaw,
    schemaName,
    messageEncoding,
  });
  expect(result.summary.topics.map(describe)).toEqual(reader.summary.topics.map(describe));
  const records = await readRecords(result);
  const [first, ...others] = await readRecords(reader);
  expect(records).toMatchObject([{ ...first!, logTimeNs: at(5) }, ...others]);
  expect(records[0]!.foreign!.schema!.data).toEqual(Uint8Array.of(7, 8));
  const without = new MemoryFile();
  await cutRecording(reader, without, { topics: ['/plain'] });
  const { summary } = await RecordingReader.open(without);
  expect(summary.topics.map(({ topic }) => topic)).toEqual(['/plain']);
});

test('a shared copy has no messages of other programs', async () => {
  const reader = await RecordingReader.open(await foreignFile());
  const pseudonyms = new Pseudonyms(createPseudonymKey((bytes) => bytes.fill(3)));
  const treatment = createTreatment(SHARING_RULES, await findPeople(reader, []), pseudonyms);
  await expect(treatRecording(reader, new MemoryFile(), treatment)).rejects.toThrow('no records');
});

/** Attachments and metadata, as the reader of other programs has them. */
async function partsOf(file: MemoryFile) {
  const reader = await McapIndexedReader.Initialize({ readable: file });
  const attachments = [];
  for await (const { type: _, data, ...facts } of reader.readAttachments())
    attachments.push({ ...facts, bytes: data.length, crc: crc32(data) });
  const metadata = [];
  for await (const { name, metadata: map } of reader.readMetadata())
    if (name !== 'ubi-interact') metadata.push([name, map.get('plate')]);
  return {
    attachments: attachments.filter(({ name }) => name !== 'ubi-interact/last-values'),
    metadata,
  };
}

test('a cut has the attachments of the span and the metadata of other programs, bit for bit', async () => {
  const file = await foreignRecording();
  const reader = await RecordingReader.open(file);
  const all = await partsOf(file);
  expect(all.attachments).toHaveLength(3);
  const cutTo = async (options: CutOptions) => {
    const target = new MemoryFile();
    await cutRecording(reader, target, options);
    return { parts: await partsOf(target), summary: (await RecordingReader.open(target)).summary };
  };

  const whole = await cutTo({});
  expect(whole.parts).toEqual(all);
  expect(whole.summary.foreignParts).toEqual(reader.summary.foreignParts);

  const span = await cutTo({ fromNs: at(5), untilNs: at(15) });
  expect(span.parts.attachments).toEqual([all.attachments[1]]);
  expect(span.parts.attachments[0]).toMatchObject({
    name: 'frame.png',
    bytes: FOREIGN_PICTURE_BYTES,
  });
  expect(span.parts.metadata).toEqual([
    ['car', 'M-AX 1'],
    ['car', 'M-AX 2'],
  ]);
});

test('a cut reads attachments in pieces, and refuses those that are none', async () => {
  const file = await foreignRecording();
  let longest = 0n;
  const source = {
    size: () => file.size(),
    read: (offset: bigint, length: bigint) => {
      if (length > longest) longest = length;
      return file.read(offset, length);
    },
  };
  const reader = await RecordingReader.open(source);
  await cutRecording(reader, new MemoryFile(), {});
  expect(longest).toBeLessThan(BigInt(FOREIGN_PICTURE_BYTES));

  const [calibration] = reader.foreignParts();
  Object.assign(calibration!.entry, { offset: 8n });
  await expect(cutRecording(reader, new MemoryFile(), {})).rejects.toThrow('calibration.yaml');
});

test('[PD-14] a shared copy has no attachments and metadata of other programs, and says so', async () => {
  const file = await foreignRecording();
  const reader = await RecordingReader.open(file);
  expect(leftOutParts(reader.summary)).toBe(
    '3 attachments and 2 metadata records of other programs',
  );
  const pseudonyms = new Pseudonyms(createPseudonymKey((bytes) => bytes.fill(3)));
  const treatment = createTreatment(SHARING_RULES, await findPeople(reader, []), pseudonyms);
  const treated = new TreatedReader(reader, treatment);
  expect(treated.foreignParts()).toEqual([]);
  expect(leftOutParts(treated.summary)).toBe('');
});
