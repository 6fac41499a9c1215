import fc from 'fast-check';
import { FakeClock } from '@ubii/timing/testing';
import { expect, it } from 'vitest';
import { RecordMemory } from '../arena/record-memory.ts';
import type { ChannelSource } from '../arena/channels.ts';
import { SharedReader } from '../arena/shared-records.ts';
import { RecordingReader } from '../reading/recording-reader.ts';
import { msOf, type RecordedRecord } from '../records/recorded-record.ts';
import { MemoryFile } from '../testing/memory-file.ts';
import { readRecords } from '../testing/read-records.ts';
import { SAMPLE_HEADER, SAMPLE_START_NS, sampleRecord } from '../testing/sample-records.ts';
import { RecordingWriter } from '../writing/recording-writer.ts';
import { FlightRecorder, type FlightSnapshot } from './flight-recorder.ts';
import { writeFlight } from './write-flight.ts';

const MS_PER_MINUTE = 60_000;

/** A flight recorder with its memory. */
function openFlight(maxMs = 60_000, maxBytes = 1_000_000) {
  const memory = new RecordMemory({ flightBytes: maxBytes, queueBytes: 0 });
  const flight = new FlightRecorder({
    clock: new FakeClock(),
    maxMarkers: 100,
    onDrop: () => undefined,
  });
  const settings = { isOn: true, minutes: maxMs / MS_PER_MINUTE, maxBytes, withImages: true };
  flight.set(settings, []);
  flight.use(memory);
  const sources = new Map<string, ChannelSource>();
  return {
    flight,
    memory,
    add({ topic, clientId, record, logTimeNs }: RecordedRecord): void {
      const source = sources.get(topic) ?? { topic, clientId, channel: undefined };
      sources.set(topic, source);
      const timeMs = msOf(logTimeNs);
      memory.add(source, record, timeMs, 1);
      flight.count(timeMs);
    },
    /** What is kept, of this moment or of an earlier one. */
    async keep(snapshot: FlightSnapshot = flight.snapshot()): Promise<RecordingReader> {
      const file = new MemoryFile();
      const header = { ...SAMPLE_HEADER, kind: 'flight-recorder' } as const;
      const writer = await RecordingWriter.create(file, header);
      await writeFlight(snapshot, new SharedReader(memory.shared, Infinity), writer);
      await writer.end();
      return RecordingReader.open(file);
    },
  };
}

const sized = (topic: string, atMs: number, bytes: number): RecordedRecord => ({
  ...sampleRecord(topic, atMs),
  record: new Uint8Array(bytes).fill(atMs),
});

it('writes what it holds, bit for bit', async () => {
  const { flight, add, keep } = openFlight();
  const records = Array.from({ length: 300 }, (_, i) =>
    sized(`/${i % 5}`, i * 10, i % 50 === 0 ? 20_000 : 30),
  );
  for (const record of records) add(record);
  expect(flight.toMessage()).toMatchObject({ heldMs: 2_990, recordCount: 300, topicCount: 5 });
  expect(await readRecords(await keep())).toEqual(records);
});

it('stays below its bytes and its time, and loses the oldest of a size class first', () => {
  // A record has its topic at least: no bytes mean that a topic lost its value.
  const bytes = fc.integer({ min: 1, max: 40_000 });
  const sample = fc.tuple(fc.constantFrom('/a', '/b', '/c'), fc.nat(400), bytes);
  const limits = fc.record({
    maxMs: fc.integer({ min: 100, max: 20_000 }),
    maxBytes: fc.integer({ min: 200_000, max: 600_000 }),
  });
  return fc.assert(
    fc.asyncProperty(limits, fc.array(sample, { maxLength: 120 }), async (limit, samples) => {
      const { flight, add, keep } = openFlight(limit.maxMs, limit.maxBytes);
      let atMs = 0;
      const added = samples.map(([topic, afterMs, bytes]) => {
        const record = sized(topic, (atMs += afterMs), bytes);
        add(record);
        const { heldBytes, heldMs } = flight.toMessage();
        expect(heldBytes).toBeLessThanOrEqual(limit.maxBytes);
        expect(heldMs).toBeLessThanOrEqual(limit.maxMs);
        return record;
      });
      const reader = await keep();
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
  const { flight, add } = openFlight();
  for (let i = 0; i < 500; i++) {
    add(sized('/camera', i * 10, 200_000));
    add(sized('/pose', i * 10, 100));
  }
  const { recordCount, heldBytes } = flight.toMessage();
  expect(heldBytes).toBeLessThanOrEqual(1_000_000);
  expect(recordCount).toBeGreaterThan(500);
});

it('writes values that stood when the window began at its beginning', async () => {
  const { add, keep } = openFlight(1_000, 100_000);
  add(sampleRecord('/setting', 0, 7));
  for (let i = 1; i <= 400; i++) add(sampleRecord('/pose', i * 10));
  const reader = await keep();
  const startNs = SAMPLE_START_NS + 3_000_000_000n;
  expect(reader.summary.startNs).toBe(startNs);
  expect(reader.summary.topics.map(({ topic }) => topic).sort()).toEqual(['/pose', '/setting']);
  expect((await reader.latestAt(startNs)).get('/setting')).toEqual({
    ...sampleRecord('/setting', 0, 7),
    logTimeNs: startNs,
  });
});

it('forgets values of topics that were deleted within the window, once it has passed', async () => {
  const { flight, add, keep } = openFlight(1_000, 100_000);
  const pass = (fromMs: number, untilMs: number): void => {
    for (let atMs = fromMs; atMs < untilMs; atMs += 10) add(sampleRecord('/pose', atMs));
  };
  const standing = async (): Promise<string[]> => {
    const { summary } = await keep();
    return summary.topics.map(({ topic }) => topic).filter((topic) => topic !== '/pose');
  };
  for (const topic of ['/gone', '/again']) add(sampleRecord(topic, 0, 7));
  pass(0, 3_000);
  for (const topic of ['/gone', '/again', '/unknown']) flight.forget(topic);
  expect(flight.toMessage()).toMatchObject({ topicCount: 3 });
  add(sampleRecord('/again', 3_000, 8));
  pass(3_000, 3_500);
  expect((await standing()).sort()).toEqual(['/again', '/gone']); // They stood when the window began.
  pass(3_500, 8_000);
  expect(await standing()).toEqual(['/again']);
  const records = await readRecords(await keep());
  expect(records.filter(({ record }) => record.length === 0)).toEqual([]);
});

it('keeps sessions as they were, and markers of the window', async () => {
  const { flight, add, keep } = openFlight(1_000);
  const timeNs = SAMPLE_START_NS;
  const session = { id: 's', name: 'mirror', state: 'running', session: '{}' };
  const marker = { id: 'm', timeMs: 0, text: 'old', author: '', authorId: '', kind: 'key' };
  flight.addEvent({ kind: 'session', timeNs, value: { ...session, state: 'created' } });
  flight.addEvent({ kind: 'session', timeNs: timeNs + 1n, value: session });
  flight.addEvent({ kind: 'marker', timeNs, value: marker });
  for (let i = 0; i <= 50; i++) add(sampleRecord('/pose', i * 100));
  const recent = { ...marker, id: 'n', text: 'new' };
  flight.addEvent({ kind: 'marker', timeNs: timeNs + 4_500_000_000n, value: recent });
  const reader = await keep();
  expect(reader.summary.markers).toEqual([recent]);
  expect((await reader.sessionsAt(reader.summary.startNs)).get('s')).toEqual(session);
});

it('[RC-32] counts what was overwritten while it was being kept, and says so', async () => {
  const { flight, add, keep } = openFlight(60_000, 40_000);
  for (let i = 0; i < 500; i++) add(sampleRecord('/pose', i));
  const before = flight.snapshot();
  for (let i = 500; i < 1_200; i++) add(sampleRecord('/pose', i));
  const reader = await keep(before);
  const kept = await readRecords(reader);
  expect(kept.length).toBeGreaterThan(0);
  const { gaps } = reader.summary;
  expect(gaps).toHaveLength(1);
  expect(gaps[0]!.records).toBe(before.records - kept.length);
  expect(gaps[0]!.reason).toContain('while these were being kept');
});
