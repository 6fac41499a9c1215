import { McapWriter } from '@mcap/core';
import fc from 'fast-check';
import { expect, it } from 'vitest';
import { MemoryFile } from '../testing/memory-file.ts';
import { readRecords } from '../testing/read-records.ts';
import { recorded } from '../testing/recorded.ts';
import { SAMPLE_START_NS, sampleRecord } from '../testing/sample-records.ts';
import { RecordingReader } from './recording-reader.ts';

const at = (ms: number): bigint => SAMPLE_START_NS + BigInt(ms) * 1_000_000n;

it('finds the last record of each topic at any moment', async () => {
  const times = fc.array(fc.tuple(fc.constantFrom('/a', '/b', '/c', '/d'), fc.nat(20_000)), {
    maxLength: 60,
  });
  await fc.assert(
    fc.asyncProperty(times, fc.nat(21_000), async (samples, moment) => {
      const records = samples.map(([topic, ms], i) => sampleRecord(topic, ms, i));
      const reader = await RecordingReader.open(await recorded(records));
      const wanted = new Map();
      for (const record of records.toSorted((a, b) => Number(a.logTimeNs - b.logTimeNs))) {
        if (record.logTimeNs <= at(moment)) wanted.set(record.topic, record);
      }
      expect(await reader.latestAt(at(moment))).toEqual(wanted);
    }),
  );
});

it('keeps records of the same time in the order in which they were written, in chunks that came out of order', async () => {
  const times = fc.array(fc.constantFrom(0, 1, 1_000, 1_001, 2_000), { maxLength: 12 });
  await fc.assert(
    fc.asyncProperty(times, async (moments) => {
      const records = moments.map((ms, i) => sampleRecord('/a', ms, i));
      const reader = await RecordingReader.open(await recorded(records));
      const wanted = records.toSorted((a, b) => Number(a.logTimeNs - b.logTimeNs));
      expect(await readRecords(reader)).toEqual(wanted);
      for (const ms of moments) {
        const last = wanted.findLast(({ logTimeNs }) => logTimeNs <= at(ms));
        expect((await reader.latestAt(at(ms))).get('/a')).toEqual(last);
      }
    }),
  );
});

/** 200 topics that got their only value far apart, and one that fills the file with noise. */
async function longRecording(): Promise<MemoryFile> {
  let seed = 1;
  const noise = (): number => (seed = (seed * 48_271) % 0x7fffffff);
  const records = Array.from({ length: 1_600 }, (_, i) => {
    if (i % 4 === 0 && i < 800) return sampleRecord(`/setting/${i / 4}`, i * 10);
    const record = Uint8Array.from({ length: 15_000 }, noise);
    return { ...sampleRecord('/noise', i * 10), record };
  });
  return recorded(records);
}

it('seeks without reading the chunks that the values are in', async () => {
  const file = await longRecording();
  const reader = await RecordingReader.open(file);
  file.readBytes = 0;
  const latest = await reader.latestAt(at(15_900));
  expect(latest.size).toBe(201);
  expect(latest.get('/setting/3')).toEqual(sampleRecord('/setting/3', 120));
  const size = Number(await file.size());
  expect(size).toBeGreaterThan(20e6);
  expect(file.readBytes).toBeLessThan(6e6);
});

it('reads only the chunks of a topic', async () => {
  const file = await longRecording();
  const reader = await RecordingReader.open(file);
  file.readBytes = 0;
  expect(await readRecords(reader, { topics: ['/setting/3'] })).toEqual([
    sampleRecord('/setting/3', 120),
  ]);
  expect(file.readBytes).toBeLessThan(2e6);
});

it('reads a span from its end to its start', async () => {
  const file = await recorded([0, 700, 1_400, 2_100, 2_800].map((ms) => sampleRecord('/a', ms)));
  const reader = await RecordingReader.open(file);
  const query = { fromNs: at(700), untilNs: at(2_100), isReverse: true };
  const times = (await readRecords(reader, query)).map(({ logTimeNs }) => logTimeNs);
  expect(times).toEqual([at(2_100), at(1_400), at(700)]);
});

it('lists messages of other programs as raw topics', async () => {
  const file = new MemoryFile();
  const writer = new McapWriter({ writable: file, useMessageIndex: false });
  await writer.start({ profile: 'ros2', library: 'other' });
  const schemaId = await writer.registerSchema({
    name: 'sensor_msgs/msg/Imu',
    encoding: 'ros2msg',
    data: new Uint8Array(),
  });
  const channelId = await writer.registerChannel({
    schemaId,
    topic: '/imu',
    messageEncoding: 'cdr',
    metadata: new Map(),
  });
  const data = Uint8Array.of(1, 2, 3);
  const times = { logTime: at(5), publishTime: at(4) };
  await writer.addMessage({ channelId, sequence: 0, data, ...times });
  await writer.end();
  const reader = await RecordingReader.open(file);
  expect(reader.summary).toMatchObject({ isForeign: true, isDamaged: false, kind: 'import' });
  expect(reader.summary.topics).toMatchObject([
    { topic: '/imu', isRaw: true, schemaName: 'sensor_msgs/msg/Imu', messageEncoding: 'cdr' },
  ]);
  expect((await reader.latestAt(at(6))).get('/imu')).toEqual({
    foreign: {
      schema: expect.objectContaining({
        name: 'sensor_msgs/msg/Imu',
        encoding: 'ros2msg',
      }) as object,
      messageEncoding: 'cdr',
      metadata: new Map(),
    },
    topic: '/imu',
    clientId: '',
    record: data,
    logTimeNs: at(5),
    publishTimeNs: at(4),
  });
});

it('lasts until the last marker, which may be after the last record', async () => {
  const timeNs = at(5_000);
  const value = {
    id: 'm',
    timeMs: Number(timeNs / 1_000_000n),
    text: 'over',
    author: 'Ada',
    authorId: 'ada',
    kind: 'button',
  };
  const marker = { kind: 'marker', timeNs, value } as const;
  const { summary } = await RecordingReader.open(await recorded([sampleRecord('/a', 0)], [marker]));
  expect(summary).toMatchObject({ startNs: at(0), endNs: timeNs });
});
