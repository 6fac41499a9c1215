import { RecordingError, RecordingReader } from '@ubii/recording';
import { csvOf, topicTable, xdfOf } from '@ubii/recording/export';
import { importCsv, importXdf, previewCsv, previewXdf } from '@ubii/recording/import';
import {
  MemoryFile,
  recorded,
  recordOfEachFormat,
  SAMPLE_START_NS,
  sampleRecord,
} from '@ubii/recording/testing';

import type { Random } from '../../random.ts';
import type { Entrance } from '../entrance.ts';
import { joined, mutateBytes } from '../mutate-bytes.ts';
import { strangeValue } from '../mutate-json.ts';

const GATE_CASES = 40;

const OPTIONS = { name: 'fuzz', version: '0.1.0', startMs: 1_750_000_000_000 };
/** What is imported at most is this many times as long as the file, and some more. */
const MAX_GROWTH = 200;
const SPARE_BYTES = 4 * 1024 * 1024;

const MARKER = { id: 'm', timeMs: 0, text: 'go', author: 'Jo', authorId: '', kind: 'key' };
const FORMATS = ['vector3', 'string', 'object2DList', 'matrix4x4', 'bool'] as const;
const OF_FORMATS = FORMATS.map((format, index) => {
  const timeNs = SAMPLE_START_NS + BigInt(index) * 1_000_000n;
  const record = recordOfEachFormat().get(format)!;
  const times = { logTimeNs: timeNs, publishTimeNs: timeNs };
  return { topic: `/format/${format}`, clientId: 'ada', record, ...times };
});
const RECORDING = await RecordingReader.open(
  await recorded(
    [...OF_FORMATS, ...Array.from({ length: 5 }, (_, index) => sampleRecord('/a', 100 + index))],
    [{ kind: 'marker', timeNs: SAMPLE_START_NS, value: MARKER }],
  ),
);

const TABLES = [
  'time,x,y\n0,1,2\n0.5,3,\n1,"4","a ""b"""\n',
  'Timestamp;Wert\r\n2024-01-02T03:04:05.123Z;1,5\r\n2024-01-02T03:04:06Z;NaN\r\n',
  'unix_ms\tcount\tname\n1750000000000\t1\t=SUM(A1)\n1750000000001\t-2e9\tä\n',
];

/** Tables that are imported, by pages and programs. */
export const csv: Entrance = {
  name: 'csv',
  about: 'the import of CSV files, in this process',
  kind: 'parser',
  gateCases: GATE_CASES,
  seeds: () => [...TABLES.map((text) => Buffer.from(text)), ...EXPORTS],
  mutate: (random, seed, other) =>
    random.oneIn(3) ? mutateBytes(random, seed, other) : mutateTable(random, seed),
  async deliver(input) {
    await allowing(() => previewCsv(new MemoryFile(input), OPTIONS));
    await allowing(() =>
      imported((sink) => importCsv(new MemoryFile(input), sink, OPTIONS), input),
    );
  },
};

/** Files of the Lab Streaming Layer. */
export const xdf: Entrance = {
  name: 'xdf',
  about: 'the import of XDF files, in this process',
  kind: 'parser',
  gateCases: GATE_CASES,
  seeds: () => [XDF],
  mutate: (random, seed, other) =>
    random.oneIn(3) ? mutateBytes(random, seed, other) : mutateXdf(random, seed, other),
  async deliver(input) {
    await allowing(() => previewXdf(new MemoryFile(input)));
    await allowing(() =>
      imported((sink) => importXdf(new MemoryFile(input), sink, OPTIONS), input),
    );
  },
};

const EXPORTS = await Promise.all(
  ['/a', '/format/vector3', '/format/object2DList', '/format/string'].map(async (topic) => {
    const parts: string[] = [];
    for await (const part of csvOf(await topicTable(RECORDING, topic))) parts.push(part);
    return Buffer.from(parts.join(''));
  }),
);

const XDF = await (async () => {
  const parts: Uint8Array[] = [];
  for await (const part of xdfOf(RECORDING)) parts.push(part.slice());
  return joined(...parts);
})();

/** An imported recording can be read again, and is not much longer than the file. */
async function imported(
  write: (sink: MemoryFile) => Promise<unknown>,
  input: Uint8Array,
): Promise<void> {
  const sink = new MemoryFile();
  await write(sink);
  const { length } = sink.bytes;
  if (length > MAX_GROWTH * input.length + SPARE_BYTES) {
    throw new Error(`${input.length} bytes became a recording of ${length}.`);
  }
  const reader = await RecordingReader.open(sink);
  if (reader.summary.isDamaged) throw new Error('The imported recording is damaged.');
}

/** Changes cells and lines. */
function mutateTable(random: Random, seed: Uint8Array): Uint8Array {
  const lines = Buffer.from(seed).toString().split('\n');
  const delimiter = random.pick([',', ';', '\t']);
  const changes = 1 + random.below(3);
  for (let i = 0; i < changes; i++) {
    const at = random.oneIn(3) ? 0 : random.below(lines.length);
    const cells = lines[at]!.split(delimiter);
    const place = random.below(cells.length);
    const text = String(strangeValue(random));
    switch (random.below(5)) {
      case 0:
        cells[place] = `"${text}"`;
        break;
      case 1:
        cells[place] = text;
        break;
      case 2:
        cells.push(...Array.from({ length: random.oneIn(10) ? 3_000 : 2 }, () => cells[place]!));
        break;
      case 3:
        cells.splice(place, 1);
        break;
      default:
        cells[place] = random.pick([
          'x[99999]',
          'a.b.c.d.e',
          '__proto__',
          'elements[0].x',
          '"',
          '',
        ]);
    }
    lines[at] = cells.join(delimiter);
    if (random.oneIn(8)) lines.splice(at, 0, ...Array.from({ length: 50 }, () => lines[at]!));
  }
  return Buffer.from(lines.join('\n'));
}

/** Changes the contents of chunks; their lengths fit, except where they are meant to lie. */
function mutateXdf(random: Random, seed: Uint8Array, other: Uint8Array): Uint8Array {
  const chunks = chunksOf(seed);
  if (chunks.length === 0) return mutateBytes(random, seed, other);
  const changes = 1 + random.below(3);
  for (let i = 0; i < changes; i++) {
    const at = random.below(chunks.length);
    const chunk = chunks[at]!;
    switch (random.below(5)) {
      case 0:
        chunks.splice(at, 1);
        break;
      case 1:
        chunks.splice(at, 0, ...Array.from({ length: random.oneIn(10) ? 500 : 1 }, () => chunk));
        break;
      default:
        chunks[at] = joined(chunk.subarray(0, 2), mutateBytes(random, chunk.subarray(2), other));
    }
    if (chunks.length === 0) return seed.subarray(0, 4);
  }
  const lying = random.oneIn(5) ? random.below(chunks.length) : -1;
  return joined(
    seed.subarray(0, 4),
    ...chunks.flatMap((chunk, at) => {
      const length = new Uint8Array(9);
      length[0] = 8;
      const stated = at === lying ? random.pick([0, 1, 3, 2 ** 28, 2 ** 40]) : chunk.length;
      new DataView(length.buffer).setBigUint64(1, BigInt(stated), true);
      return [length, chunk];
    }),
  );
}

/** Tag and content of each chunk. */
function chunksOf(file: Uint8Array): Uint8Array[] {
  const view = new DataView(file.buffer, file.byteOffset, file.byteLength);
  const chunks: Uint8Array[] = [];
  for (let at = 4; at + 3 <= file.length;) {
    const bytes = file[at]!;
    if ((bytes !== 1 && bytes !== 4 && bytes !== 8) || at + 1 + bytes > file.length) break;
    const length =
      bytes === 1
        ? view.getUint8(at + 1)
        : bytes === 4
          ? view.getUint32(at + 1, true)
          : Number(view.getBigUint64(at + 1, true));
    const begin = at + 1 + bytes;
    if (begin + length > file.length) break;
    chunks.push(file.subarray(begin, begin + length));
    at = begin + length;
  }
  return chunks;
}

/** @throws what is no documented error */
async function allowing(read: () => Promise<unknown>): Promise<void> {
  try {
    await read();
  } catch (error) {
    if (!(error instanceof RecordingError)) throw error;
  }
}
