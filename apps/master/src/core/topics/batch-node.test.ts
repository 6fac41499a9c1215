import { describe, expect, it, vi } from 'vitest';
import { BatchNode } from './batch-node.ts';
import { TopicEntry } from './topic-entry.ts';

const entry = new TopicEntry('/a');
const bytes = (...values: number[]): Uint8Array => Uint8Array.from(values);

describe('BatchNode', () => {
  it('holds its records in order, with their length [TD-30]', () => {
    const batch = BatchNode.empty()
      .append(entry, bytes(1), false)
      .append(entry, bytes(2, 3), false);
    expect(batch.records).toEqual([bytes(1), bytes(2, 3)]);
    expect(batch.byteLength).toBe(3);
    expect(batch.count).toBe(2);
  });

  it('leaves the batch it was appended to as it is', () => {
    const first = BatchNode.empty().append(entry, bytes(1), false);
    first.append(entry, bytes(2), false);
    expect(first.records).toEqual([bytes(1)]);
  });

  it('is the same batch for all subscribers of the same records', () => {
    const root = BatchNode.empty();
    const [one, two] = [bytes(1), bytes(2)];
    const ada = root.append(entry, one, false).append(entry, two, false);
    const ben = root.append(entry, one, false).append(entry, two, false);
    const cleo = root.append(entry, two, false);
    expect(ben).toBe(ada);
    expect(cleo).not.toBe(ada);
  });

  it('tells equal bytes of two records apart', () => {
    const root = BatchNode.empty();
    expect(root.append(entry, bytes(1), false)).not.toBe(root.append(entry, bytes(1), false));
  });

  it('makes what an encoder asks for once, for each encoder', () => {
    const batch = BatchNode.empty().append(entry, bytes(1), false);
    const encoders = ['legacy', 'list', 'other'].map((name) => ({ encode: vi.fn(() => name) }));
    for (let i = 0; i < 2; i++) {
      expect(encoders.map((encoder) => batch.memo(encoder))).toEqual(['legacy', 'list', 'other']);
    }
    for (const { encode } of encoders) expect(encode).toHaveBeenCalledTimes(1);
  });
});
