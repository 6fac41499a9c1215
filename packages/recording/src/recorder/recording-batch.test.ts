import { expect, it } from 'vitest';
import { OpenBatch, recordsOf } from './recording-batch.ts';

const sourceOf = (topic: string) => ({ topic, clientId: 'ada', batchNumber: -1, place: 0 });
const filled = (byteLength: number, value: number) => new Uint8Array(byteLength).fill(value);

it('gives back small and large records in order, of each batch its own', () => {
  const batch = new OpenBatch();
  const [pose, camera] = [sourceOf('/pose'), sourceOf('/camera')];
  for (const from of [1, 100]) {
    const added = Array.from({ length: 9 }, (_, i) => ({
      source: i % 3 === 0 ? camera : pose,
      record: filled(i % 3 === 0 ? 16_385 + i : 10 + i, from + i),
      timeMs: from + i,
      targets: 1 + (i % 2),
    }));
    for (const { source, record, timeMs, targets } of added) {
      batch.add(source, record, timeMs, targets);
    }
    const taken = batch.take();
    expect(recordsOf(taken)).toEqual(added);
    expect(taken.byteLength).toBe(added.reduce((sum, { record }) => sum + record.length, 0));
  }
});

it('copies records: what they lie in may be used again', () => {
  const batch = new OpenBatch();
  const memory = filled(40_000, 7);
  batch.add(sourceOf('/camera'), memory.subarray(0, 20_000), 1, 1);
  batch.add(sourceOf('/pose'), memory.subarray(20_000, 20_010), 2, 1);
  memory.fill(0);
  const taken = batch.take();
  expect(recordsOf(taken).map(({ record }) => record)).toEqual([filled(20_000, 7), filled(10, 7)]);
  // The recorder keeps the large one where it lies.
  expect(taken.large.map(({ buffer }) => buffer.byteLength)).toEqual([20_000]);
});
