import { decodeRecord, encodeRecord, type RecordInit } from '@ubii/proto';
import { describe, expect, test } from 'vitest';
import { csvOf, topicTable } from '../../export/index.ts';
import { RecordingReader } from '../../reading/recording-reader.ts';
import { MemoryFile, recorded, recordOfEachFormat, SAMPLE_START_NS } from '../../testing/index.ts';
import { importCsv, previewCsv } from './import-csv.ts';

const BASE = { name: 'Table', version: '0.1.0', startMs: 1_750_000_000_000 };
type Options = Partial<Parameters<typeof importCsv>[2]>;

const fileOf = (text: string): MemoryFile => new MemoryFile(new TextEncoder().encode(text));

async function imported(text: string, options: Options = {}) {
  const file = new MemoryFile();
  const result = await importCsv(fileOf(text), file, { ...BASE, ...options });
  const reader = await RecordingReader.open(file);
  const records = [];
  for await (const { topic, clientId, record, logTimeNs, publishTimeNs } of reader.records()) {
    const { format, value } = decodeRecord(record);
    records.push({ topic, clientId, format, value, logTimeNs, publishTimeNs });
  }
  const seen = records.map(({ topic, value, logTimeNs }) => [
    ...[topic, value, Number(logTimeNs) / 1e6 - BASE.startMs],
  ]);
  return { reader, records, seen, result };
}

describe('an export that is imported', () => {
  async function roundTrip(inits: readonly RecordInit[]) {
    const records = inits.map((init, i) => ({
      topic: '/lab/a',
      clientId: 'ada',
      record: encodeRecord(init),
      logTimeNs: SAMPLE_START_NS + BigInt(i) * 1_000_001n,
      publishTimeNs: SAMPLE_START_NS + BigInt(i) * 1_000_001n - 7n,
    }));
    const source = await RecordingReader.open(await recorded(records));
    let text = '';
    for await (const part of csvOf(await topicTable(source, '/lab/a'))) text += part;
    const { records: found } = await imported(text);
    return { records, found };
  }

  test('has the values, publishers and both times of the recording', async () => {
    const inits: RecordInit[] = [
      { topic: '/lab/a', format: 'vector2', value: { x: 0.1, y: -2e-9 } },
      { topic: '/lab/a', format: 'string', value: '=1,"ä"\n-' },
      { topic: '/lab/a', format: 'pose3D', value: { position: { x: 1, y: 2, z: 3 } } },
      { topic: '/lab/a', format: 'vector3List', value: { elements: [{ x: 1 }, { z: NaN }] } },
      {
        topic: '/lab/a',
        format: 'object2DList',
        value: { elements: [{ id: '7', size: { x: 2 } }] },
      },
      { topic: '/lab/a', format: 'stringList', value: { elements: ['', 'a', '', 'b'] } },
      { topic: '/lab/a', format: 'int32List', value: { elements: [3, -4] } },
      { topic: '/lab/a' },
    ];
    const { records, found } = await roundTrip(inits);
    expect(found).toEqual(
      records.map(({ record, ...head }) => {
        const { format, value } = decodeRecord(record);
        return { ...head, format, value };
      }),
    );
  });

  test('has every data format but pictures', async () => {
    for (const [format, record] of recordOfEachFormat()) {
      if (format.startsWith('image2D')) continue;
      const init = decodeRecord(record) as RecordInit;
      const { found } = await roundTrip([init]);
      expect([format, found[0]?.value]).toEqual([format, init.value]);
    }
  });
});

describe('another table', () => {
  test('has a topic for each column, and no record for an empty cell', async () => {
    const { seen } = await imported(
      'time [ms],Speed (m/s),on,note\n0,1.5,true,\n2.5,,FALSE,"a, b"\n',
    );
    expect(seen).toEqual([
      ['/Table/Speed-m-s', 1.5, 0],
      ['/Table/on', true, 0],
      ['/Table/on', false, 2.5],
      ['/Table/note', 'a, b', 2.5],
    ]);
  });

  test('has a topic for each row, of the format that fits the names of its columns', async () => {
    const options = { layout: 'object', topic: '/head' } as const;
    const vectors = await imported('t;x;y;z\n1;1,5;2;3\n', options);
    expect(vectors.seen).toEqual([['/head', { x: 1.5, y: 2, z: 3 }, 1000]]);
    const poses = await imported('t,position.x,quaternion.w\n0,4,1\n', options);
    expect(poses.records[0]).toMatchObject({ format: 'pose3D', value: { position: { x: 4 } } });
    const lists = await imported('t,Fz,C3\n0,1,\n1,2,3\n', options);
    expect(lists.records[0]).toMatchObject({ format: 'doubleList', value: { elements: [1, NaN] } });
    expect(lists.reader.summary.notes).toBe('/head: Fz, C3');
  });

  test.each([
    ['time_ns', '1750000000123456789', 123.456789],
    ['timestamp', '1750000000.5', 500],
    ['time', '1750000000250', 250],
    ['Time (s)', '0.25', 250],
    ['date', '2025-06-15T17:06:40.125+02:00', 125],
    ['when', '2025-06-15 15:06:40', 0],
  ])('finds the unit of %s with %s', async (name, time, ms) => {
    const { records } = await imported(`v,${name}\n1,${time}\n`);
    expect(records[0]!.logTimeNs).toBe(SAMPLE_START_NS + BigInt(Math.round(ms * 1e6)));
  });

  test('takes the column and the unit that are named, and the topics that are chosen', async () => {
    const options = { timeColumn: 'a', timeUnit: 'us', topics: ['/Table/time'] } as const;
    const { seen } = await imported('time,a,b\n5,1000,6\n', options);
    expect(seen).toEqual([['/Table/time', 5, 1]]);
  });

  test('is looked at before', async () => {
    const plan = await previewCsv(fileOf('t,x,y\n0,1,2\n'), { name: 'walk', layout: 'object' });
    expect(plan).toMatchObject({
      isExport: false,
      time: { place: 0, unit: 's' },
      topics: [{ topic: '/walk', format: 'vector2' }],
    });
    const none = await previewCsv(fileOf('a,b\n0,1\n'), { name: 'walk' });
    expect(none.time).toBeUndefined();
  });
});

/** Beyond the rows by which columns are told. */
const ROWS = '0,1\n'.repeat(300);

test.each([
  ['no times', 'a,b\n1,2\n', 'No column has times. Choose one of "a", "b".'],
  ['too few cells', 't,a\n0,1\n1\n', 'Line 3 has 1 cells, and the header has 2.'],
  ['an open quote', 't,a\n0,"1\n', 'Line 2: the quote has no end.'],
  ['a text among numbers', `t,a\n${ROWS}1,x\n`, 'Line 302, column "a": "x" is not a number'],
  ['a broken time', `t,a\n${ROWS}x,1\n`, 'Line 302, column "t": "x" is no time.'],
  ['nothing', '', 'The file is empty.'],
  ['no rows', 't,a\n', 'The table has a header and no rows.'],
  [
    'an unknown format',
    'time,time_ms,arrived,arrived_ms,publisher,topic,format,x\n,,,,,/a,vector9,1\n',
    'Line 2, column "format": "vector9" is no data format.',
  ],
])('a table with %s is refused, with the place', async (_what, text, sentence) => {
  await expect(imported(text)).rejects.toThrow(sentence);
});

test('an import can be cancelled, and says how far it is', async () => {
  const shares: number[] = [];
  await imported('t,a\n0,1\n', { onProgress: (share) => shares.push(share) });
  expect(shares).toEqual([1]);
  const signal = AbortSignal.abort(new Error('cancelled'));
  await expect(imported('t,a\n0,1\n', { signal })).rejects.toThrow('cancelled');
});
