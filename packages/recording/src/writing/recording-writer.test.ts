import { expect, it } from 'vitest';
import { RecordingReader } from '../reading/recording-reader.ts';
import { repairRecording } from '../repair/repair-recording.ts';
import { MemoryFile } from '../testing/memory-file.ts';
import { SAMPLE_HEADER, SAMPLE_START_NS, sampleRecord } from '../testing/sample-records.ts';
import { RecordingWriter } from './recording-writer.ts';

async function begin() {
  const file = new MemoryFile();
  return { file, writer: await RecordingWriter.create(file, SAMPLE_HEADER) };
}

it('closes a chunk with the record that is one second later than its first', async () => {
  const { file, writer } = await begin();
  const before = file.position();
  expect(writer.addRecord(sampleRecord('/a', 0))).toBeUndefined();
  expect(writer.addRecord(sampleRecord('/a', 999))).toBeUndefined();
  expect(file.position()).toBe(before);
  await writer.addRecord(sampleRecord('/a', 1_000));
  expect(file.position()).toBeGreaterThan(before);
});

it('closes a chunk with 1 MiB', async () => {
  const { file, writer } = await begin();
  const before = file.position();
  const record = { ...sampleRecord('/a', 0), record: new Uint8Array(600_000) };
  expect(writer.addRecord(record)).toBeUndefined();
  await writer.addRecord(record);
  expect(file.position()).toBeGreaterThan(before);
});

it('tells the failure of a full disk, and leaves a file that can be repaired', async () => {
  const { file, writer } = await begin();
  await writer.addRecord(sampleRecord('/a', 0));
  await writer.flush();
  file.maxBytes = Number(file.position()) + 10;
  await writer.addRecord(sampleRecord('/a', 100));
  await expect(writer.flush()).rejects.toThrow('ENOSPC');
  expect(() => writer.addRecord(sampleRecord('/a', 200))).toThrow('ENOSPC');
  await expect(writer.end()).rejects.toThrow('ENOSPC');
  file.maxBytes = Infinity;
  expect(await repairRecording(file)).toMatchObject({ records: 1 });
});

it('gives each publisher of a topic a channel of its own, with name and format', async () => {
  const { file, writer } = await begin();
  const value = { id: 'bob', name: "Bob's phone", tags: ['phone'], state: 'active' };
  writer.addEvent({ kind: 'client', timeNs: SAMPLE_START_NS, value });
  await writer.addRecord(sampleRecord('/a', 0));
  await writer.addRecord({ ...sampleRecord('/a', 1), clientId: 'bob' });
  await writer.addRecord(sampleRecord('/a', 2));
  expect(writer.statistics).toMatchObject({ records: 3, topics: 2, markers: 0 });
  await writer.end();
  const { summary } = await RecordingReader.open(file);
  expect(summary.topics).toMatchObject([
    { topic: '/a', clientId: 'ada', clientName: '', format: 'double', records: 2, isRaw: false },
    { topic: '/a', clientId: 'bob', clientName: "Bob's phone", format: 'double', records: 1 },
  ]);
  expect(summary.clients).toEqual([value]);
});

it('refuses further topics when the file has as many channels as it can', async () => {
  const { writer } = await begin();
  const record = sampleRecord('/', 0);
  for (let i = 0; i < 66_000; i++) void writer.addRecord({ ...record, topic: `/${i}` });
  expect(writer.statistics).toMatchObject({ topics: 65_529, refusedRecords: 471 });
  await writer.end();
});

it('writes what else happened, to be found at its moment', async () => {
  const { file, writer } = await begin();
  const session = (state: string, atMs: bigint) =>
    ({
      kind: 'session',
      timeNs: SAMPLE_START_NS + atMs * 1_000_000n,
      value: { id: 's', name: 'mirror', state, session: '{"name":"mirror"}' },
    }) as const;
  const clock = {
    kind: 'clock',
    timeNs: SAMPLE_START_NS,
    value: { clientId: 'ada', offsetMs: 3.5, errorMs: 0.4, driftPpm: 12 },
  } as const;
  const gap = { topic: '/a', fromMs: 1, untilMs: 2, records: 30, reason: 'writer too slow' };
  writer.addEvent(session('running', 0n));
  writer.addEvent(session('stopped', 500n));
  writer.addEvent(clock);
  writer.addEvent({ kind: 'gap', timeNs: SAMPLE_START_NS, value: gap });
  await writer.end();
  const reader = await RecordingReader.open(file);
  expect((await reader.sessionsAt(SAMPLE_START_NS - 1n)).size).toBe(0);
  expect((await reader.sessionsAt(SAMPLE_START_NS)).get('s')?.state).toBe('running');
  expect((await reader.sessionsAt(SAMPLE_START_NS + 500_000_000n)).get('s')?.state).toBe('stopped');
  expect((await reader.sessions()).map(({ value }) => value.state)).toEqual(['running', 'stopped']);
  expect(await reader.clocks()).toEqual([clock]);
  expect(reader.summary).toMatchObject({ gaps: [gap], records: 0, topics: [], startNs: 0n });
});
