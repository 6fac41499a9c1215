import { decodeRecord, encodeRecord, type RecordInit } from '@ubii/proto';
import { expect, test } from 'vitest';
import {
  headerXml,
  clockOffset,
  fileHeader,
  samples,
  streamHeader,
  type StreamFacts,
} from '../../export/xdf/xdf-chunks.ts';
import { xdfOf } from '../../export/index.ts';
import { RecordingReader } from '../../reading/recording-reader.ts';
import { MemoryFile, recorded, SAMPLE_START_NS } from '../../testing/index.ts';
import { importXdf, previewXdf } from './import-xdf.ts';

const START_S = Number(SAMPLE_START_NS / 1_000_000_000n);
const BASE = { name: 'EEG', version: '0.1.0', startMs: START_S * 1000 };

function joined(parts: readonly Uint8Array[]): MemoryFile {
  return new MemoryFile(new Uint8Array(Buffer.concat(parts)));
}

/** A stream of irregular rate. */
function stream(id: number, facts: Partial<StreamFacts> = {}): Uint8Array {
  const plain = { name: 'A & B', type: 'EEG', channels: ['x'], format: 'double64' } as const;
  return streamHeader(id, headerXml({ ...plain, sourceId: `s${id}`, host: 'lab', ...facts }));
}

/** A chunk of samples whose bytes are given, after the number of the stream. */
function rawSamples(id: number, count: number, content: readonly number[]): Uint8Array {
  const length = 2 + 4 + 2 + content.length;
  return Uint8Array.of(...[1, length, 3, 0, id, 0, 0, 0, 1, count], ...content);
}

async function imported(file: MemoryFile, options: Partial<Parameters<typeof importXdf>[2]> = {}) {
  const target = new MemoryFile();
  const result = await importXdf(file, target, { ...BASE, ...options });
  const reader = await RecordingReader.open(target);
  const records = [];
  for await (const { topic, clientId, record, logTimeNs } of reader.records()) {
    const { format, value } = decodeRecord(record);
    records.push({ topic, clientId, format, value, seconds: Number(logTimeNs) / 1e9 - START_S });
  }
  return { result, reader, records };
}

test('an export that is imported has the topics, publishers, values and markers of the recording', async () => {
  const inits: RecordInit[] = [
    { topic: '/v', format: 'vector2', value: { x: NaN, y: 2 } },
    { topic: '/t', format: 'string', value: '<ä>' },
    { topic: '/l', format: 'vector2List', value: { elements: [{ x: 1 }] } },
    { topic: '/l', format: 'vector2List', value: { elements: [{ x: 1 }, { y: 3 }] } },
    { topic: '/b', format: 'bool', value: true },
  ];
  const records = inits.map((init, i) => {
    const timeNs = SAMPLE_START_NS + BigInt(i) * 1_000_000_000n;
    const times = { logTimeNs: timeNs, publishTimeNs: timeNs };
    return { topic: init.topic, clientId: 'ada', record: encodeRecord(init), ...times };
  });
  const marker = {
    id: 'm',
    timeMs: BASE.startMs + 500,
    text: 'go',
    author: 'Jo',
    authorId: '',
    kind: 'key',
  };
  const value = { id: 'ada', name: 'Ada', tags: [], state: 'active' };
  const events = [
    { kind: 'client', timeNs: SAMPLE_START_NS, value },
    { kind: 'marker', timeNs: SAMPLE_START_NS + 500_000_000n, value: marker },
  ] as const;
  const source = await RecordingReader.open(await recorded(records, events));
  const parts: Uint8Array[] = [];
  for await (const part of xdfOf(source)) parts.push(part);
  const found = await imported(joined(parts));
  const expected = records.map(({ topic, clientId, record }, seconds) => {
    const { format, value: whole } = decodeRecord(record);
    return { topic, clientId, format, value: whole, seconds };
  });
  expect(found.records).toEqual(expected);
  expect(found.reader.summary.markers).toMatchObject([{ text: 'go', timeMs: marker.timeMs }]);
  expect(found.reader.summary.topics[0]).toMatchObject({ clientName: 'Ada' });
  expect(found.reader.summary).toMatchObject({ kind: 'import', name: 'EEG' });
});

test('samples of all formats are read, and those without a time follow the one before', async () => {
  const numbers = new DataView(new ArrayBuffer(27));
  numbers.setFloat32(0, -0.5, true);
  numbers.setFloat64(4, 1e300, true);
  numbers.setInt8(12, -7);
  numbers.setInt16(13, -300, true);
  numbers.setInt32(15, 70_000, true);
  numbers.setBigInt64(19, -5n, true);
  const bytesOf = (at: number, length: number) => [...new Uint8Array(numbers.buffer, at, length)];
  const time = [8, ...new Uint8Array(new Float64Array([START_S]).buffer)];
  const cases = [
    ['float32', bytesOf(0, 4), -0.5],
    ['double64', bytesOf(4, 8), 1e300],
    ['int8', bytesOf(12, 1), -7],
    ['int16', bytesOf(13, 2), -300],
    ['int32', bytesOf(15, 4), 70_000],
    ['int64', bytesOf(19, 8), -5],
    ['string', [1, 2, 0xc3, 0xa4], 'ä'],
  ] as const;
  for (const [format, content, value] of cases) {
    const facts = { format: format as 'double64' };
    const header = stream(1, facts);
    const xml = new TextDecoder().decode(header).replace(/.*(<\?xml.*)/s, '$1');
    const regular = streamHeader(1, xml.replace('<nominal_srate>0<', '<nominal_srate>4<'));
    const chunk = rawSamples(1, 2, [...time, ...content, 0, ...content]);
    const { records } = await imported(joined([fileHeader(), regular, chunk]));
    expect([format, ...records.map((one) => [one.value, one.seconds.toFixed(6)])]).toEqual([
      ...[format, [value, '0.000000'], [value, '0.250000']],
    ]);
  }
});

test('streams become topics by their name, with lists for several channels, and markers', async () => {
  const { records, reader } = await imported(
    joined([
      ...[fileHeader(), stream(1), stream(2, { channels: ['Fz', 'C3'] })],
      stream(3, { name: 'keys', type: 'Markers', channels: ['text'], format: 'string' }),
      samples(1, [{ time: START_S, values: [1] }]),
      samples(2, [{ time: START_S + 1, values: [2, 3] }]),
      samples(3, [{ time: START_S + 2, values: ['go'] }]),
    ]),
  );
  expect(records).toEqual([
    { topic: '/A-B', clientId: 's1', format: 'double', value: 1, seconds: 0 },
    {
      topic: '/A-B',
      clientId: 's2',
      format: 'doubleList',
      value: { elements: [2, 3] },
      seconds: 1,
    },
  ]);
  expect(reader.summary.markers).toMatchObject([{ text: 'go', author: 'keys' }]);
  expect(reader.summary.notes).toBe('/A-B: Fz, C3');
});

test('offsets of clocks are applied, and outliers move them little', async () => {
  const offsets = Array.from({ length: 20 }, (_, i) => {
    const spike = i === 7 ? 0.05 : 0;
    return clockOffset(1, START_S + i, -2 - i * 1e-5 + spike);
  });
  const values = Array.from({ length: 20 }, (_, i) => ({ time: START_S + i, values: [i] }));
  const { records } = await imported(
    joined([fileHeader(), stream(1), samples(1, values), ...offsets]),
  );
  for (const { seconds, value } of records) {
    expect(seconds).toBeCloseTo((value as number) * (1 - 1e-5) - 2, 4);
  }
});

test('a clock that was reset has a line of its own after that', async () => {
  const at = (i: number): number => START_S + i + (i < 10 ? 0 : 1000);
  const offsets = Array.from({ length: 20 }, (_, i) => clockOffset(1, at(i), i < 10 ? -2 : -1002));
  const values = Array.from({ length: 20 }, (_, i) => ({ time: at(i), values: [i] }));
  const { records } = await imported(
    joined([fileHeader(), stream(1), ...offsets, samples(1, values)]),
  );
  for (const { seconds, value } of records) expect(seconds).toBeCloseTo((value as number) - 2, 4);
});

test('times since the start of a computer begin when the file says, or the caller', async () => {
  const content = [
    stream(1),
    samples(1, [
      { time: 5000.5, values: [1] },
      { time: 5001, values: [2] },
    ]),
  ];
  const { records } = await imported(joined([fileHeader(), ...content]));
  expect(records.map(({ seconds }) => seconds)).toEqual([0, 0.5]);
});

test('a damaged file is read up to the damage, and says so', async () => {
  const whole = [fileHeader(), stream(1), samples(1, [{ time: START_S, values: [1] }])];
  const broken = rawSamples(1, 9, [8, 0, 0]);
  const after = samples(1, [{ time: START_S + 1, values: [2] }]);
  for (const end of [[after.slice(0, -3)], [Uint8Array.of(7, 1, 2)], [broken, after]]) {
    const file = joined([...whole, ...end]);
    const { records, result } = await imported(file);
    expect(records.map(({ value }) => value)).toEqual([1]);
    expect(result.leftOut[0]).toMatch(
      /^The file is damaged at byte \d+: what follows was not read/,
    );
  }
  expect((await previewXdf(joined([...whole, Uint8Array.of(7)]))).damage).toContain('is damaged');
});

test.each([
  ['a file of another format', Buffer.from('MCAP0000'), 'The file is no XDF file.'],
  ['a compressed file', Uint8Array.of(0x1f, 0x8b, 8, 0), 'Unpack the file first'],
  ['a file without streams', fileHeader(), 'The file has no streams.'],
  ['a file without samples', Buffer.concat([fileHeader(), stream(1)]), 'The file has no values.'],
])('%s is refused', async (_what, bytes, sentence) => {
  await expect(imported(joined([bytes]))).rejects.toThrow(sentence);
});

test('streams are shown before, and chosen', async () => {
  const file = joined([
    ...[fileHeader(), stream(1), stream(2, { name: 'other' })],
    ...[samples(1, [{ time: START_S, values: [1] }]), samples(2, [{ time: START_S, values: [2] }])],
  ]);
  const { topics } = await previewXdf(file);
  expect(topics.map(({ topic, format }) => [topic, format])).toEqual([
    ['/A-B', 'double'],
    ['/other', 'double'],
  ]);
  const { records } = await imported(file, { topics: ['/other'] });
  expect(records.map(({ value }) => value)).toEqual([2]);
});
