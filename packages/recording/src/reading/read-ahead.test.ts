import { describe, expect, it } from 'vitest';
import type { RecordedRecord } from '../records/recorded-record.ts';
import type { RecordingEvent } from '../records/recording-event.ts';
import { RecordingWriter } from '../writing/recording-writer.ts';
import { MemoryFile } from '../testing/memory-file.ts';
import { readRecords } from '../testing/read-records.ts';
import { SAMPLE_HEADER, SAMPLE_START_NS, sampleRecord } from '../testing/sample-records.ts';
import { RecordingReader } from './recording-reader.ts';

const SECONDS = 60;
const at = (second: number): bigint => SAMPLE_START_NS + BigInt(second) * 1_000_000_000n;

function clockAt(second: number): RecordingEvent {
  const value = { clientId: 'ada', offsetMs: 1, errorMs: 0.8, driftPpm: 0 };
  return { kind: 'clock', timeNs: at(second), value };
}

/** A minute with a chunk of 50 kB and a chunk with a clock in each second; `/rare` is in the first second only. */
async function writeMinute(): Promise<Uint8Array> {
  let seed = 1;
  const noise = (): number => (seed = (seed * 48_271) % 0x7fffffff);
  const file = new MemoryFile();
  const writer = await RecordingWriter.create(file, SAMPLE_HEADER);
  await writer.addRecord(sampleRecord('/rare', 0));
  for (let second = 0; second < SECONDS; second++) {
    writer.addEvent(clockAt(second));
    const record = Uint8Array.from({ length: 50_000 }, noise);
    await writer.addRecord({ ...sampleRecord('/noise', second * 1000), record });
  }
  await writer.end();
  return file.bytes;
}

const written = writeMinute();

async function aMinute() {
  const file = new MemoryFile(await written);
  const reader = await RecordingReader.open(file);
  file.reads = 0;
  file.readBytes = 0;
  return { file, reader };
}

/** Records are large: comparing all of their bytes takes long. */
const outlineOf = ({ topic, logTimeNs, record }: RecordedRecord): unknown => [
  topic,
  logTimeNs,
  record.length,
  record.at(-1),
];

describe('reading ahead', () => {
  it('reads neighbouring chunks together, each byte once', async () => {
    const { file, reader } = await aMinute();
    expect(await readRecords(reader)).toHaveLength(SECONDS + 1);
    expect(file.reads).toBeLessThan(8);
    expect(file.readBytes).toBeLessThan(file.bytes.length);
  });

  it('gives the same records from the end to the start', async () => {
    const { file, reader } = await aMinute();
    const reversed = await readRecords(reader, { isReverse: true, isOnce: true });
    expect(file.reads).toBeLessThan(8);
    const all = await readRecords(reader, { isOnce: true });
    expect(reversed.reverse().map(outlineOf)).toEqual(all.map(outlineOf));
  });

  it('reads one chunk for a reader that takes one record', async () => {
    const { file, reader } = await aMinute();
    for await (const { topic } of reader.records()) {
      expect(topic).toBe('/rare');
      break;
    }
    expect(file.reads).toBe(1);
    expect(file.readBytes).toBeLessThan(100_000);
  });

  it('needs no read for the events between chunks that were read', async () => {
    const { file, reader } = await aMinute();
    await readRecords(reader, { isOnce: true });
    file.reads = 0;
    expect(await reader.clocks()).toHaveLength(SECONDS);
    // The first events stand before the first chunk.
    expect(file.reads).toBeLessThanOrEqual(1);
  });

  it('leaves the chunks of others in memory when everything is read once', async () => {
    const { file, reader } = await aMinute();
    const latest = await reader.latestAt(at(30));
    await readRecords(reader, { isOnce: true });
    file.reads = 0;
    const again = await reader.latestAt(at(30));
    expect([...again.values()].map(outlineOf)).toEqual([...latest.values()].map(outlineOf));
    expect(file.reads).toBe(0);
  });

  it('tells a failure of a read ahead when its chunk is asked for', async () => {
    const { file, reader } = await aMinute();
    await file.truncate(BigInt(Math.floor(file.bytes.length * 0.9)));
    const seen: bigint[] = [];
    const all = (async () => {
      for await (const { logTimeNs } of reader.records()) seen.push(logTimeNs);
    })();
    await expect(all).rejects.toThrow('ends before');
    expect(seen.length).toBeGreaterThan(10);
  });
});
