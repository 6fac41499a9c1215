import { expect, it } from 'vitest';
import type { RecordingEvent } from '../records/recording-event.ts';
import { MemoryFile } from '../testing/memory-file.ts';
import { recorded } from '../testing/recorded.ts';
import { SAMPLE_START_NS, sampleRecord } from '../testing/sample-records.ts';
import { OutlineReader } from './outline-reader.ts';
import { RecordingReader } from './recording-reader.ts';

const START_MS = Number(SAMPLE_START_NS / 1_000_000n);

function markerAt(ms: number, id: string, isRemoved = false): RecordingEvent {
  const value = { id, timeMs: START_MS + ms, text: `mark ${id}`, author: '', authorId: '' };
  const timeNs = SAMPLE_START_NS + BigInt(ms) * 1_000_000n;
  return { kind: 'marker', timeNs, value: { ...value, kind: 'key', isRemoved } };
}

/** `/a` is published for 20 s, ten times a second; `/b` only in the second half, five times a second. */
async function aRecording(): Promise<MemoryFile> {
  const records = Array.from({ length: 200 }, (_, i) => [
    sampleRecord('/a', i * 100),
    ...(i >= 100 && i % 2 === 0 ? [sampleRecord('/b', i * 100)] : []),
  ]).flat();
  return recorded(records, [markerAt(5000, 'm'), markerAt(6000, 'n'), markerAt(6000, 'n', true)]);
}

const sum = (numbers: Iterable<number>): number => [...numbers].reduce((a, b) => a + b, 0);

it('counts the records of each topic over time from the index alone', async () => {
  const file = await aRecording();
  const reader = await OutlineReader.open(file);
  file.readBytes = 0;
  const { activity, topics, startNs, endNs } = await reader.outline(4);
  expect([startNs, endNs]).toEqual([SAMPLE_START_NS, SAMPLE_START_NS + 19_900_000_000n]);
  expect(sum(activity)).toBeCloseTo(250, 2);
  const [a, b] = topics.map((topic) => [...topic.activity].map(Math.round));
  expect(a!.every((count) => Math.abs(count - 50) <= 6)).toBe(true);
  expect(sum(b!.slice(0, 2))).toBeLessThanOrEqual(3);
  expect(sum(b!)).toBeCloseTo(50, -1);
  // Header and the chunk of the markers.
  expect(file.readBytes).toBeLessThan(2000);
});

it('is what the reader of the whole recording tells, where the publishers of a topic are counted together', async () => {
  const records = Array.from({ length: 100 }, (_, i) => ({
    ...sampleRecord(i % 4 === 0 ? '/b' : '/a', i * 100),
    clientId: i % 2 === 0 ? 'ada' : 'bob',
  }));
  const file = await recorded(records);
  const reader = await RecordingReader.open(file);
  file.readBytes = 0;
  const { all, topics } = reader.activity(4);
  expect(file.readBytes).toBe(0);
  expect(all).toEqual((await (await OutlineReader.open(file)).outline(4)).activity);
  expect(sum(topics.get('/a')!)).toBeCloseTo(75, 2);
  expect(sum(topics.get('/b')!)).toBeCloseTo(25, 2);
});

it('has the markers that are not removed', async () => {
  const { markers } = await (await OutlineReader.open(await aRecording())).outline(4);
  expect(markers.map(({ text }) => text)).toEqual(['mark m']);
});

it('finds a record near a moment', async () => {
  const reader = await OutlineReader.open(await aRecording());
  const middleNs = SAMPLE_START_NS + 10_000_000_000n;
  const near = await reader.recordNear('/a', middleNs, 1e6);
  expect(Math.abs(Number(near!.logTimeNs - middleNs)) / 1e9).toBeLessThan(1.5);
  expect(await reader.recordNear('/a', middleNs, 10)).toBeUndefined();
  expect(await reader.recordNear('/none', middleNs, 1e6)).toBeUndefined();
});

it('outlines an empty recording', async () => {
  const { activity, topics, endNs } = await (
    await OutlineReader.open(await recorded([]))
  ).outline(3);
  expect([...activity]).toEqual([0, 0, 0]);
  expect([topics, endNs]).toEqual([[], 0n]);
});

it('refuses a file without its end rather than reading all of it', async () => {
  const { bytes } = await aRecording();
  const cut = new MemoryFile(bytes.slice(0, bytes.length - 100));
  await expect(OutlineReader.open(cut)).rejects.toThrow('The end of the file is missing.');
  expect(cut.readBytes).toBeLessThan(1000);
  await expect(OutlineReader.open(new MemoryFile(new Uint8Array(50)))).rejects.toThrow(
    'not an MCAP',
  );
});
