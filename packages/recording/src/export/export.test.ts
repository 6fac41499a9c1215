import { expect, test } from 'vitest';
import { encodeRecord, type RecordInit } from '@ubii/proto';
import { parquetReadObjects } from 'hyparquet';
import { MemoryFile } from '../testing/index.ts';
import { RecordingReader } from '../reading/recording-reader.ts';
import { RecordingWriter } from '../writing/recording-writer.ts';
import { csvOf, topicTable, writeParquet, xdfOf } from './index.ts';

const START_NS = 1_790_000_000_000_000_000n;
const MS = 1_000_000n;

/** A recording with one record every 10 ms, which the publisher stamped 2.5 ms before it came. */
async function recordingOf(records: readonly RecordInit[]): Promise<RecordingReader> {
  const file = new MemoryFile();
  const writer = await RecordingWriter.create(file, {
    name: 'Test',
    kind: 'recording',
    masterName: 'Lab',
    version: '0.1.0',
    notes: '',
    selection: '{}',
  });
  for (const [place, record] of records.entries()) {
    const logTimeNs = START_NS + BigInt(place) * 10n * MS;
    await writer.addRecord({
      topic: record.topic,
      clientId: record.clientId ?? '',
      record: encodeRecord(record),
      logTimeNs,
      publishTimeNs: logTimeNs - 2_500_000n,
    });
  }
  await writer.end();
  return RecordingReader.open(file);
}

async function textOf(parts: AsyncIterable<string>): Promise<string> {
  let whole = '';
  for await (const part of parts) whole += part;
  return whole;
}

const vector = (x: number, y: number): RecordInit => ({
  topic: '/a',
  format: 'vector2',
  value: { x, y },
  clientId: 'c1',
});

test('a table has a column for each member, and cells that are empty where a record has none', async () => {
  const reader = await recordingOf([
    { topic: '/lists', format: 'vector2List', value: { elements: [{ x: 1, y: 2 }] } },
    {
      topic: '/lists',
      format: 'vector2List',
      value: {
        elements: [
          { x: 3, y: 4 },
          { x: 5, y: 6 },
        ],
      },
    },
    { topic: '/lists' },
  ]);
  const table = await topicTable(reader, '/lists');
  expect(table.columns.map(({ name }) => name)).toEqual(['0.x', '0.y', '1.x', '1.y']);
  const rows = [];
  for await (const { cells } of table.rows()) rows.push(cells);
  expect(rows).toEqual([
    [1, 2, undefined, undefined],
    [3, 4, 5, 6],
    [undefined, undefined, undefined, undefined],
  ]);
});

test('a topic whose values change their type has texts', async () => {
  const reader = await recordingOf([
    { topic: '/mixed', format: 'double', value: 1.5 },
    { topic: '/mixed', format: 'string', value: 'two' },
  ]);
  const table = await topicTable(reader, '/mixed');
  expect(table.columns).toEqual([{ name: 'value', type: 'string' }]);
  expect(await textOf(csvOf(table))).toContain(',1.5\r\n');
});

test('CSV has both times without loss, and no formulas', async () => {
  const reader = await recordingOf([
    { topic: '/text', format: 'string', value: '=1+1', clientId: 'c1' },
  ]);
  const table = await topicTable(reader, '/text');
  expect(await textOf(csvOf(table, (id) => (id === 'c1' ? 'Ada, "A"' : id)))).toBe(
    'time,time_ms,arrived,arrived_ms,publisher,topic,format,value\r\n' +
      '2026-09-21T14:13:19.997500000Z,1789999999997.5,2026-09-21T14:13:20.000000000Z,' +
      `1790000000000,"Ada, ""A""",/text,string,'=1+1\r\n`,
  );
});

test('Parquet holds numbers, truth values, texts and gaps', async () => {
  const reader = await recordingOf([
    vector(0.1, -2),
    vector(NaN, 1e300),
    { topic: '/a', format: 'string', value: 'text', clientId: 'c2' },
  ]);
  const parts: Uint8Array[] = [];
  await writeParquet(await topicTable(reader, '/a'), (part) => void parts.push(part));
  const file = await new Blob(parts as BlobPart[]).arrayBuffer();
  expect(await parquetReadObjects({ file })).toEqual([
    row(0, 'c1', { x: 0.1, y: -2, value: null }),
    row(1, 'c1', { x: NaN, y: 1e300, value: null }),
    row(2, 'c2', { x: null, y: null, value: 'text' }),
  ]);
});

function row(place: number, publisher: string, value: object): object {
  const time = START_NS + BigInt(place) * 10n * MS;
  return { publish_time_ns: time - 2_500_000n, log_time_ns: time, publisher, ...value };
}

test('an export that is aborted ends with the reason', async () => {
  const reader = await recordingOf([vector(1, 2)]);
  const signal = AbortSignal.abort(new Error('cancelled'));
  await expect(topicTable(reader, '/a', { signal })).rejects.toThrow('cancelled');
});

test('XDF begins with its mark and has a stream for each topic of each publisher', async () => {
  const reader = await recordingOf([
    vector(1, 2),
    { ...vector(3, 4), clientId: 'c2' } as RecordInit,
    { topic: '/b', format: 'string', value: 'a<b&c\u0007' },
  ]);
  const parts: Uint8Array[] = [];
  for await (const part of xdfOf(reader)) parts.push(part);
  const text = Buffer.concat(parts).toString('latin1');
  expect(text.startsWith('XDF:')).toBe(true);
  expect([...text.matchAll(/<source_id>(.*?)<\/source_id>/g)].map(([, id]) => id)).toEqual([
    'c1/a',
    'c2/a',
    '/b',
  ]);
  expect(text).toContain('<channel_format>double64</channel_format>');
  expect(text).toContain('<channel_format>string</channel_format>');
});
