import { execFile } from 'node:child_process';
import { mkdtemp, rm, truncate, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { decodeRecord, encodeRecord, type RecordInit } from '@ubii/proto';
import { RecordingReader, RecordingWriter, repairRecording } from '@ubii/recording';
import { xdfOf } from '@ubii/recording/export';
import {
  headerXml,
  clockOffset,
  fileHeader,
  samples,
  streamHeader,
} from '../../../packages/recording/src/export/xdf/xdf-chunks.ts';
import { importXdf } from '@ubii/recording/import';
import { DiskFile } from '@ubii/recording/node';
import { MemoryFile } from '@ubii/recording/testing';
import { afterAll, beforeAll, describe, expect, inject, test } from 'vitest';

const SCRIPT = join(import.meta.dirname, '../clients/mcap/recordings.py');
const START_NS = 1_750_000_000_000_000_000n;
const HEADER = {
  name: 'Tuesday',
  kind: 'recording',
  masterName: 'lab',
  version: '0.1.0',
  notes: 'ä',
  selection: '{}',
} as const;
const MARKER = {
  id: 'm',
  timeMs: 1_750_000_000_000,
  text: 'start',
  author: 'Ada',
  authorId: 'ada',
  kind: 'key',
};

const RECORDS: RecordInit[] = [
  { topic: '/number', format: 'double', value: 0.25 },
  { topic: '/pose', format: 'pose3D', value: { position: { x: 1, y: 2, z: 3 } } },
  { topic: '/names', format: 'stringList', value: { elements: ['a', 'b'] } },
  {
    topic: '/camera',
    format: 'image2D',
    value: { width: 2, height: 1, data: Uint8Array.of(7, 8) },
  },
  { topic: '/empty' },
];

const installation = inject('mcap');
const suite = 'mcap 1.6.0 with mcap-protobuf-support 0.6.0, and pyxdf 1.17.5';

describe.skipIf('missing' in installation)(suite, () => {
  let folder: string;
  beforeAll(async () => {
    folder = await mkdtemp(join(tmpdir(), 'ubii-recordings-'));
  });
  afterAll(() => rm(folder, { recursive: true, force: true }));

  async function python(command: string, path: string) {
    if ('missing' in installation) throw new Error(installation.missing);
    const interpreter = join(installation.folder, 'bin/python');
    const { stdout } = await promisify(execFile)(interpreter, [SCRIPT, command, path]);
    return JSON.parse(stdout) as Record<string, unknown>;
  }

  async function record(path: string): Promise<{ readonly dataEnd: number }> {
    const file = await DiskFile.create(path);
    const writer = await RecordingWriter.create(file, HEADER);
    const client = { id: 'ada', name: "Ada's phone", tags: [], state: 'active' };
    writer.addEvent({ kind: 'client', timeNs: START_NS, value: client });
    writer.addEvent({ kind: 'marker', timeNs: START_NS, value: MARKER });
    for (const [i, init] of RECORDS.entries()) {
      const logTimeNs = START_NS + BigInt(i) * 700_000_000n;
      const head = { topic: init.topic, clientId: 'ada', logTimeNs, publishTimeNs: logTimeNs - 5n };
      await writer.addRecord({ ...head, record: encodeRecord(init) });
    }
    await writer.flush();
    const dataEnd = Number(file.position());
    await writer.end();
    await file.close();
    return { dataEnd };
  }

  const WHOLE = {
    profile: 'ubi-interact',
    metadata: { 'ubi-interact': HEADER },
    messages: RECORDS.length + 2,
    events: [
      { topic: '/recording/clients', value: { id: 'ada', name: "Ada's phone" } },
      { topic: '/recording/markers', value: MARKER },
    ],
    records: [
      {
        topic: '/number',
        clientName: "Ada's phone",
        type: 'ubii.topicData.TopicDataRecord',
        logTime: String(START_NS),
        publishTime: String(START_NS - 5n),
        value: { topic: '/number', double: 0.25 },
      },
      { value: { topic: '/pose', pose3D: { position: { x: 1, y: 2, z: 3 } } } },
      { value: { topic: '/names', stringList: { elements: ['a', 'b'] } } },
      { value: { topic: '/camera', image2D: { width: 2, height: 1, data: 'Bwg=' } } },
      { value: { topic: '/empty' } },
    ],
  };

  test('opens our recordings and decodes their records by the schema inside', async () => {
    const path = join(folder, 'ours.mcap');
    await record(path);
    expect(await python('read', path)).toMatchObject(WHOLE);
  });

  test('opens recordings that were cut off and repaired', async () => {
    const path = join(folder, 'cut.mcap');
    const { dataEnd } = await record(path);
    await truncate(path, dataEnd - 10);
    const file = await DiskFile.edit(path);
    expect(await repairRecording(file)).toMatchObject({ records: RECORDS.length });
    await file.close();
    expect(await python('read', path)).toMatchObject(WHOLE);
  });

  test('writes files that are read here, as raw topics', async () => {
    const path = join(folder, 'theirs.mcap');
    await python('write', path);
    const file = await DiskFile.open(path);
    const reader = await RecordingReader.open(file);
    expect(reader.summary).toMatchObject({ isForeign: true, kind: 'import', records: 1_000 });
    expect(reader.summary.topics).toMatchObject([
      { topic: '/foreign', isRaw: true, schemaName: 'sample', messageEncoding: 'json' },
    ]);
    const latest = await reader.latestAt(START_NS + 500_000_000n);
    const { record: bytes, publishTimeNs } = latest.get('/foreign')!;
    expect(JSON.parse(new TextDecoder().decode(bytes))).toEqual({ i: 500, text: '' });
    expect(publishTimeNs).toBe(START_NS + 500_000_000n - 5n);
    await file.close();
  });

  test('opens an export as XDF, and brings the times of each publisher to those of the master', async () => {
    const path = join(folder, 'clock.mcap');
    const file = await DiskFile.create(path);
    const writer = await RecordingWriter.create(file, HEADER);
    for (let i = 0; i < 10; i++) {
      const logTimeNs = START_NS + BigInt(i) * 1_000_000_000n;
      const clock = { clientId: 'ada', offsetMs: 2_000, errorMs: 1, driftPpm: 0 };
      writer.addEvent({ kind: 'clock', timeNs: logTimeNs, value: clock });
      const value = { x: i, y: 10 - i };
      await writer.addRecord({
        topic: '/place',
        clientId: 'ada',
        logTimeNs,
        publishTimeNs: logTimeNs + 2_000_000_000n,
        record: encodeRecord({ topic: '/place', format: 'vector2', value }),
      });
    }
    writer.addEvent({ kind: 'marker', timeNs: START_NS, value: MARKER });
    await writer.end();
    const parts: Uint8Array[] = [];
    for await (const part of xdfOf(await RecordingReader.open(file))) parts.push(part);
    await file.close();
    const xdf = join(folder, 'clock.xdf');
    await writeFile(xdf, Buffer.concat(parts));
    const { streams } = (await python('xdf', xdf)) as {
      streams: { name: string; times: number[]; values: unknown[] }[];
    };
    expect(streams.map(({ name }) => name)).toEqual(['/place', 'Markers']);
    const [place, markers] = streams;
    expect(place!.values).toEqual(Array.from({ length: 10 }, (_, i) => [i, 10 - i]));
    for (const [i, time] of place!.times.entries()) {
      expect(time).toBeCloseTo(Number(START_NS / 1_000_000_000n) + i, 5);
    }
    expect(markers!.values).toEqual([['start']]);
  });

  test('reads the same times and values of an XDF file as the import here, with clocks that drift and reset', async () => {
    const xdf = join(folder, 'drift.xdf');
    await writeFile(xdf, Buffer.concat(driftingStreams()));
    const { streams } = (await python('xdf', xdf)) as {
      streams: { name: string; times: number[]; values: number[][] }[];
    };
    const source = await DiskFile.open(xdf);
    const target = new MemoryFile();
    await importXdf(source, target, { name: 'Drift', version: '0.1.0' });
    await source.close();
    const reader = await RecordingReader.open(target);
    for (const { name, times, values } of streams) {
      const found = [];
      for await (const { record: bytes, logTimeNs } of reader.records({ topics: [`/${name}`] })) {
        const { value } = decodeRecord(bytes) as { value: { elements: number[] } };
        found.push({ value: value.elements, time: Number(logTimeNs) / 1e9 });
      }
      expect(found.map(({ value }) => value)).toEqual(values);
      const error = Math.max(...found.map(({ time }, i) => Math.abs(time - times[i]!)));
      expect(error).toBeLessThan(1e-6);
    }
    expect(streams.map(({ name }) => name)).toEqual(['drift', 'reset', 'plain']);
  });
});

/** Streams whose clocks drift with noise and outliers, are reset, and are the recorder's. */
function driftingStreams(): Uint8Array[] {
  const begin = 1_750_000_000;
  const noise = (i: number): number => Math.sin(i * 12.9898) * 2e-4 + (i % 9 === 4 ? 0.03 : 0);
  const parts = [fileHeader()];
  for (const [place, name] of ['drift', 'reset', 'plain'].entries()) {
    const stream = place + 1;
    const facts = { name, type: 'EEG', channels: ['a', 'b'], format: 'double64' } as const;
    parts.push(streamHeader(stream, headerXml({ ...facts, sourceId: name, host: 'lab' })));
    const at = (i: number): number => begin + 5 * i + (name === 'reset' && i >= 30 ? 5_000 : 0);
    for (let i = 0; i < 60; i++) {
      const offset = 1.5 + i * 4e-5 + noise(i) - (name === 'reset' && i >= 30 ? 5_000 : 0);
      if (name !== 'plain') parts.push(clockOffset(stream, at(i), offset));
      const list = [0, 1, 2].map((k) => ({ time: at(i) + k, values: [i, i / 7 + k] }));
      parts.push(samples(stream, list));
    }
  }
  return parts;
}
