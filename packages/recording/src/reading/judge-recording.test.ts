import type { ChunkIndex } from '@mcap/core';
import { DEFAULT_TEXT_LIMITS } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { encodeEnd } from '../mcap/file-index.ts';
import { readIndex } from '../mcap/open-file.ts';
import type { RecordingEvent } from '../records/recording-event.ts';
import { foreignRecording } from '../testing/foreign-recording.ts';
import { MemoryFile } from '../testing/memory-file.ts';
import { recorded } from '../testing/recorded.ts';
import { SAMPLE_HEADER, SAMPLE_START_NS, sampleRecord } from '../testing/sample-records.ts';
import { RecordingWriter } from '../writing/recording-writer.ts';
import { judgeRecording } from './judge-recording.ts';
import { RecordingReader } from './recording-reader.ts';

const LIMITS = { ...DEFAULT_TEXT_LIMITS, markersPerRecording: 3, personalLabels: 2 };
const MARKER = { id: 'a', timeMs: 1, text: 'Go', author: 'Ada', authorId: 'ada', kind: 'key' };
const RECORDS = Array.from({ length: 300 }, (_, i) => sampleRecord(`/topic/${i % 3}`, i * 25));

/** An event as no recorder would write it. */
function event(kind: RecordingEvent['kind'], value: unknown): RecordingEvent {
  return { kind, timeNs: SAMPLE_START_NS, value } as RecordingEvent;
}

/** A complete file, whose index says something else of its last chunk. */
async function withIndex(change: (chunk: ChunkIndex) => Partial<ChunkIndex>): Promise<MemoryFile> {
  const file = await recorded(RECORDS, [event('marker', MARKER)]);
  const { index, dataEnd } = (await readIndex(file))!;
  const last = index.chunks.pop()!;
  index.chunks.push({ ...last, ...change(last) });
  await file.truncate(dataEnd);
  await file.write(encodeEnd(index, dataEnd));
  return file;
}

/** A complete file with labels of personal data. */
async function withLabels(personalData: string): Promise<MemoryFile> {
  const file = new MemoryFile();
  await (await RecordingWriter.create(file, { ...SAMPLE_HEADER, personalData })).end();
  return file;
}

describe('judgeRecording', () => {
  it('takes recordings, and files of other programs', async () => {
    await judgeRecording(await recorded(RECORDS, [event('marker', MARKER)]), LIMITS);
    await judgeRecording(await foreignRecording(), LIMITS);
  });

  it.each<[string, (chunk: ChunkIndex) => Partial<ChunkIndex>, string]>([
    ['place', ({ chunkStartOffset: at }) => ({ chunkStartOffset: at + 1n }), 'it is not there'],
    ['length', ({ chunkLength }) => ({ chunkLength: chunkLength - 1n }), 'another length'],
    ['first time', () => ({ messageStartTime: 0n }), 'other times'],
    ['last time', ({ messageEndTime }) => ({ messageEndTime: messageEndTime + 1n }), 'other times'],
    ['decompressed size', () => ({ uncompressedSize: 1n }), 'another size'],
    ['size', ({ compressedSize }) => ({ compressedSize: compressedSize + 1n }), 'another size'],
    ['compression', () => ({ compression: 'zstd' }), 'compressed in another way'],
    ['list of channels', () => ({ messageIndexOffsets: new Map([[99, 0n]]) }), 'other channels'],
  ])('[RC-55] refuses a file whose index has a wrong %s of a chunk', async (_, change, lie) => {
    const judged = judgeRecording(await withIndex(change), LIMITS);
    await expect(judged).rejects.toMatchObject({ name: 'RecordingError' });
    await expect(judged).rejects.toThrow(/The index of the file is wrong about chunk \d+: /);
    await expect(judged).rejects.toThrow(lie);
  });

  it.each(['marker', 'client', 'device', 'session', 'clock', 'gap'] as const)(
    '[RC-55] refuses a file with a malformed %s',
    async (kind) => {
      const file = await recorded(RECORDS, [event(kind, { id: 'a', text: {} })]);
      await expect(judgeRecording(file, LIMITS)).rejects.toThrow(`The ${kind} event of 20`);
    },
  );

  it.each([
    ['no JSON', '{', 'cannot be read'],
    ['no labels', '{"labels":5}', 'cannot be read'],
    ['too many', JSON.stringify({ labels: [{}, {}, {}] }), 'has 3 labels'],
    ['too long', JSON.stringify({ labels: [{}, { note: 'x'.repeat(5_000) }] }), 'label 2 of'],
  ])('[RC-54] refuses a file with labels that are %s', async (_, personalData, problem) => {
    const judged = judgeRecording(await withLabels(personalData), LIMITS);
    await expect(judged).rejects.toThrow(problem);
  });

  it('[RC-23] refuses a file with more markers than a recording may have', async () => {
    const events = Array.from({ length: 4 }, () => event('marker', MARKER));
    await expect(judgeRecording(await recorded([], events), LIMITS)).rejects.toThrow('4 markers');
  });
});

it('[RC-55] RecordingReader leaves malformed events out, and counts them', async () => {
  const events = [event('marker', {}), event('marker', { ...MARKER, text: {} })];
  const file = await recorded(RECORDS, [...events, event('marker', MARKER)]);
  const { summary, malformed } = await RecordingReader.open(file);
  expect(summary.markers).toEqual([MARKER]);
  expect(malformed).toEqual({
    count: 2,
    first: expect.stringContaining('id is missing') as string,
  });
});
