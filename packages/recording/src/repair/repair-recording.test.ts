import fc from 'fast-check';
import { beforeAll, expect, it } from 'vitest';
import { readIndex } from '../mcap/open-file.ts';
import { RecordingReader } from '../reading/recording-reader.ts';
import { RecordingError } from '../records/recording-error.ts';
import type { RecordedRecord } from '../records/recorded-record.ts';
import { MemoryFile } from '../testing/memory-file.ts';
import { readRecords } from '../testing/read-records.ts';
import { recorded } from '../testing/recorded.ts';
import { SAMPLE_HEADER, SAMPLE_START_NS, sampleRecord } from '../testing/sample-records.ts';
import { RecordingWriter } from '../writing/recording-writer.ts';
import { changeRecording, repairRecording } from './repair-recording.ts';

const RECORDS = Array.from({ length: 400 }, (_, i) => sampleRecord(`/topic/${i % 7}`, i * 25));
let whole: Uint8Array;
/** How many bytes of the file hold so many records: one entry for each chunk. */
let chunks: { readonly end: number; readonly records: number }[];

beforeAll(async () => {
  const file = new MemoryFile();
  const writer = await RecordingWriter.create(file, SAMPLE_HEADER);
  const headerEnd = Number(file.position());
  for (const record of RECORDS) await writer.addRecord(record);
  await writer.end();
  whole = file.bytes;
  const { index } = (await readIndex(file))!;
  let records = 0;
  chunks = [{ end: headerEnd, records }];
  for (const chunk of index.chunks) {
    const inChunk = ({ logTimeNs }: RecordedRecord) =>
      logTimeNs >= chunk.messageStartTime && logTimeNs <= chunk.messageEndTime;
    records += RECORDS.filter(inChunk).length;
    chunks.push({ end: Number(chunk.chunkStartOffset + chunk.chunkLength), records });
  }
});

it('keeps every record of whole chunks, wherever the file is cut', async () => {
  expect(chunks.length).toBeGreaterThan(8);
  const everyByte = fc.integer({ min: 8, max: whole.length - 1 });
  const nearEnds = fc
    .tuple(fc.nat(chunks.length - 1), fc.integer({ min: -40, max: 40 }))
    .map(([at, offset]) => Math.min(chunks[at]!.end + offset, whole.length - 1));
  await fc.assert(
    fc.asyncProperty(fc.oneof(everyByte, nearEnds), async (length) => {
      const file = new MemoryFile(whole.subarray(0, length));
      const kept = chunks.findLast(({ end }) => end <= length)?.records ?? 0;
      const damaged = await RecordingReader.open(file);
      expect(damaged.summary).toMatchObject({ isDamaged: true, records: kept });
      expect(await repairRecording(file)).toMatchObject({
        records: kept,
        lostAfterNs: kept === 0 ? undefined : RECORDS[kept - 1]!.logTimeNs,
      });
      const repaired = await RecordingReader.open(file);
      expect(repaired.summary.isDamaged).toBe(false);
      expect(await readRecords(repaired)).toEqual(RECORDS.slice(0, kept));
      expect(await repairRecording(file)).toBeUndefined();
    }),
    { numRuns: 150 },
  );
});

it('cuts what a failed disk left behind the last chunk', async () => {
  const { end, records } = chunks[5]!;
  const file = new MemoryFile(whole.subarray(0, end));
  await file.write(new Uint8Array(5_000));
  expect(await repairRecording(file)).toMatchObject({ records, cutBytes: 5_000 });
});

it('cuts a chunk whose content is not what was written', async () => {
  const broken = whole.slice();
  broken[chunks[4]!.end - 3]! ^= 255;
  const file = new MemoryFile(broken.subarray(0, chunks[6]!.end));
  expect(await repairRecording(file)).toMatchObject({ records: chunks[3]!.records });
});

it('repairs to the file that the writer would have ended', async () => {
  const end = Number((await readIndex(new MemoryFile(whole)))!.dataEnd);
  const file = new MemoryFile(whole.subarray(0, end));
  await repairRecording(file);
  expect(Buffer.compare(file.bytes, whole)).toBe(0);
});

it('refuses what is no MCAP file', async () => {
  const file = new MemoryFile(new TextEncoder().encode('topic;time;value\n'));
  await expect(repairRecording(file)).rejects.toThrow(RecordingError);
  await expect(RecordingReader.open(new MemoryFile())).rejects.toThrow(RecordingError);
});

const marker = (id: string, text: string, isRemoved?: boolean) =>
  ({
    kind: 'marker',
    timeNs: SAMPLE_START_NS,
    value: { id, timeMs: 1, text, author: 'Ada', authorId: 'ada', kind: 'key', isRemoved },
  }) as const;

it('adds, changes and removes markers of a complete file, and renames it', async () => {
  const file = await recorded(RECORDS, [marker('a', 'start'), marker('b', 'oops')]);
  const events = [marker('b', 'oops', true), marker('a', 'begin'), marker('c', 'end')];
  await changeRecording(file, { events, header: { ...SAMPLE_HEADER, name: 'Wednesday' } });
  const reader = await RecordingReader.open(file);
  expect(reader.summary.name).toBe('Wednesday');
  expect(reader.summary.markers.map(({ id, text }) => [id, text])).toEqual([
    ['a', 'begin'],
    ['c', 'end'],
  ]);
  expect(await readRecords(reader)).toEqual(RECORDS);
});

it('leaves a file as it was when a change cannot be written', async () => {
  const file = await recorded(RECORDS, [marker('a', 'start')]);
  const before = file.bytes;
  file.maxBytes = before.length;
  const change = { events: [marker('b', 'end')] };
  await expect(changeRecording(file, change)).rejects.toThrow('ENOSPC');
  expect(file.bytes).toEqual(before);
});

it('changes nothing in a file without its end', async () => {
  const file = new MemoryFile(whole.subarray(0, -9));
  await expect(changeRecording(file, {})).rejects.toThrow('Repair it first');
});

it('refuses a file that begins with another record than a header', async () => {
  const headerBytes =
    9 + Number(new DataView(whole.buffer, whole.byteOffset).getBigUint64(9, true));
  const bytes = new Uint8Array([...whole.subarray(0, 8), ...whole.subarray(8 + headerBytes)]);
  const file = new MemoryFile(bytes.slice(0, -20));
  await expect(repairRecording(file)).rejects.toThrow(RecordingError);
});
