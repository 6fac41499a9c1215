import { encodeRecord } from '@ubii/proto';
import fc from 'fast-check';
import { expect, it } from 'vitest';
import { RecordingReader } from '../reading/recording-reader.ts';
import type { RecordedRecord } from '../records/recorded-record.ts';
import { MemoryFile } from '../testing/memory-file.ts';
import { readRecords } from '../testing/read-records.ts';
import { SAMPLE_HEADER, SAMPLE_START_NS, sampleRecord } from '../testing/sample-records.ts';
import { RecordingWriter } from '../writing/recording-writer.ts';
import { FlightRing } from './flight-ring.ts';

async function keep(ring: FlightRing): Promise<RecordingReader> {
  const file = new MemoryFile();
  const writer = await RecordingWriter.create(file, { ...SAMPLE_HEADER, kind: 'flight-recorder' });
  await ring.writeTo(writer);
  await writer.end();
  return RecordingReader.open(file);
}

const sized = (topic: string, atMs: number, bytes: number): RecordedRecord => ({
  ...sampleRecord(topic, atMs),
  record: new Uint8Array(bytes).fill(atMs),
});
const WHOLE = { maxMs: 60_000, maxBytes: 1_000_000, withImages: true };

it('writes what it holds, bit for bit', async () => {
  const ring = new FlightRing(WHOLE);
  const records = Array.from({ length: 300 }, (_, i) =>
    sized(`/${i % 5}`, i * 10, i % 50 === 0 ? 20_000 : 30),
  );
  for (const record of records) ring.addRecord(record);
  expect(ring.content).toMatchObject({ heldMs: 2_990, records: 300, topics: 5 });
  expect(await readRecords(await keep(ring))).toEqual(records);
});

it('stays below its bytes and its time, and loses the oldest of a size class first', () => {
  // A record has its topic at least: no bytes mean that a topic lost its value.
  const bytes = fc.integer({ min: 1, max: 40_000 });
  const sample = fc.tuple(fc.constantFrom('/a', '/b', '/c'), fc.nat(400), bytes);
  const limits = fc.record({
    maxMs: fc.integer({ min: 100, max: 20_000 }),
    maxBytes: fc.integer({ min: 100_000, max: 600_000 }),
    withImages: fc.constant(true),
  });
  return fc.assert(
    fc.asyncProperty(limits, fc.array(sample, { maxLength: 120 }), async (limit, samples) => {
      const ring = new FlightRing(limit);
      let atMs = 0;
      const added = samples.map(([topic, afterMs, bytes]) => {
        const record = sized(topic, (atMs += afterMs), bytes);
        ring.addRecord(record);
        expect(ring.content.heldBytes).toBeLessThanOrEqual(limit.maxBytes);
        expect(ring.content.heldMs).toBeLessThanOrEqual(limit.maxMs);
        return record;
      });
      const reader = await keep(ring);
      const kept = await readRecords(reader);
      for (const isLarge of [true, false]) {
        const ofClass = ({ record }: RecordedRecord) => record.length > 16_384 === isLarge;
        const last = kept.filter(ofClass).map(({ record }) => record.length);
        const wanted = added.filter(ofClass).map(({ record }) => record.length);
        // At the beginning stand the values that are older: one for each topic at most.
        const inWindow = last.slice(isLarge ? 0 : Math.min(3, last.length));
        expect(wanted.slice(wanted.length - inWindow.length)).toEqual(inWindow);
      }
      expect((await reader.latestAt(reader.summary.endNs)).size).toBeLessThanOrEqual(3);
    }),
    { numRuns: 60 },
  );
});

it('keeps what small records said while pictures fill the memory', () => {
  const ring = new FlightRing(WHOLE);
  for (let i = 0; i < 500; i++) {
    ring.addRecord(sized('/camera', i * 10, 200_000));
    ring.addRecord(sized('/pose', i * 10, 100));
  }
  const { records, heldBytes } = ring.content;
  expect(heldBytes).toBeLessThanOrEqual(1_000_000);
  expect(records).toBeGreaterThan(500);
});

it('keeps large records where they lie, and of a view a copy', async () => {
  const ring = new FlightRing(WHOLE);
  const alone = sized('/camera', 1, 20_000);
  const memory = new Uint8Array(60_000).fill(5);
  const view = { ...sized('/camera', 2, 0), record: memory.subarray(0, 20_000) };
  for (const record of [alone, view]) ring.addRecord(record);
  alone.record.fill(9);
  memory.fill(9);
  const kept = await readRecords(await keep(ring));
  expect(kept.map(({ record }) => record[0])).toEqual([9, 5]);
  expect(ring.content.heldBytes).toBeLessThan(41_000);
});

it('leaves out images when they are not wanted', () => {
  const ring = new FlightRing({ ...WHOLE, withImages: false });
  const value = { width: 1, height: 1, data: Uint8Array.of(1) };
  const record = encodeRecord({ topic: '/camera', format: 'image2D', value });
  ring.addRecord({ ...sampleRecord('/camera', 0), record });
  ring.addRecord(sampleRecord('/pose', 0));
  expect(ring.content).toMatchObject({ records: 1, topics: 1 });
});

it('writes values that stood when the window began at its beginning', async () => {
  const ring = new FlightRing({ ...WHOLE, maxMs: 1_000, maxBytes: 100_000 });
  ring.addRecord(sampleRecord('/setting', 0, 7));
  for (let i = 1; i <= 400; i++) ring.addRecord(sampleRecord('/pose', i * 10));
  const reader = await keep(ring);
  const startNs = SAMPLE_START_NS + 3_000_000_000n;
  expect(reader.summary.startNs).toBe(startNs);
  expect(reader.summary.topics.map(({ topic }) => topic).sort()).toEqual(['/pose', '/setting']);
  expect((await reader.latestAt(startNs)).get('/setting')).toEqual({
    ...sampleRecord('/setting', 0, 7),
    logTimeNs: startNs,
  });
});

it('forgets values of topics that were deleted within the window, once it has passed', async () => {
  const ring = new FlightRing({ ...WHOLE, maxMs: 1_000, maxBytes: 100_000 });
  const pass = (fromMs: number, untilMs: number): void => {
    for (let atMs = fromMs; atMs < untilMs; atMs += 10) ring.addRecord(sampleRecord('/pose', atMs));
  };
  const standing = async (): Promise<string[]> => {
    const { summary } = await keep(ring);
    return summary.topics.map(({ topic }) => topic).filter((topic) => topic !== '/pose');
  };
  for (const topic of ['/gone', '/again']) ring.addRecord(sampleRecord(topic, 0, 7));
  pass(0, 3_000);
  for (const topic of ['/gone', '/again', '/unknown']) ring.forget(topic);
  expect(ring.content).toMatchObject({ topics: 3 });
  ring.addRecord(sampleRecord('/again', 3_000, 8));
  pass(3_000, 3_500);
  expect((await standing()).sort()).toEqual(['/again', '/gone']); // They stood when the window began.
  pass(3_500, 8_000);
  expect(await standing()).toEqual(['/again']);
  const records = await readRecords(await keep(ring));
  expect(records.filter(({ record }) => record.length === 0)).toEqual([]);
});

it('keeps sessions as they were, and markers of the window', async () => {
  const ring = new FlightRing({ ...WHOLE, maxMs: 1_000 });
  const timeNs = SAMPLE_START_NS;
  const session = { id: 's', name: 'mirror', state: 'running', session: '{}' };
  const marker = { id: 'm', timeMs: 0, text: 'old', author: '', authorId: '', kind: 'key' };
  ring.addEvent({ kind: 'session', timeNs, value: { ...session, state: 'created' } });
  ring.addEvent({ kind: 'session', timeNs: timeNs + 1n, value: session });
  ring.addEvent({ kind: 'marker', timeNs, value: marker });
  for (let i = 0; i <= 50; i++) ring.addRecord(sampleRecord('/pose', i * 100));
  const recent = { ...marker, id: 'n', text: 'new' };
  ring.addEvent({ kind: 'marker', timeNs: timeNs + 4_500_000_000n, value: recent });
  const reader = await keep(ring);
  expect(reader.summary.markers).toEqual([recent]);
  expect((await reader.sessionsAt(reader.summary.startNs)).get('s')).toEqual(session);
});

it('starts over when the clock is set back', () => {
  const ring = new FlightRing(WHOLE);
  ring.addRecord(sampleRecord('/a', 10_000_000));
  ring.addRecord(sampleRecord('/a', 0));
  expect(ring.content).toMatchObject({ records: 1, heldMs: 0 });
});

it('obeys new limits at once, and forgets all when cleared', () => {
  const ring = new FlightRing(WHOLE);
  for (let i = 0; i < 2_000; i++) ring.addRecord(sized('/a', i, 400));
  ring.setLimits({ ...WHOLE, maxBytes: 100_000 });
  expect(ring.content.heldBytes).toBeLessThanOrEqual(100_000);
  ring.clear();
  expect(ring.content).toEqual({ heldMs: 0, heldBytes: 0, records: 0, topics: 0 });
});
