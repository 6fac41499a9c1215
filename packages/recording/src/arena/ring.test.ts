import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { RingReader, type RingEntry } from './shared-ring.ts';
import { RingWriter, type ReleasedEntry } from './ring-writer.ts';

const CAPACITY = 8 * 1024;

/** A record of one repeated byte that begins anywhere in its memory. */
function recordOf(value: number, length: number, byteOffset = 0): Uint8Array {
  return new Uint8Array(new ArrayBuffer(byteOffset + length), byteOffset).fill(value % 256);
}

/** A ring that notes what left it. */
function openRing(capacity = CAPACITY) {
  const released: number[] = [];
  const settled: number[][] = [];
  let passing: number[] = [];
  const ring = new RingWriter(capacity, {
    release: ({ channel }: ReleasedEntry) => {
      released.push(channel);
      passing.push(channel);
    },
    settle: () => {
      settled.push(passing);
      passing = [];
    },
  });
  let count = 0;
  const add = (record: Uint8Array, timeMs = count, bound = capacity): boolean => {
    const isKept = ring.add(record, { channel: count, targets: 3, timeMs, order: count }, bound);
    if (isKept) count++;
    return isKept;
  };
  const read = (reader = new RingReader(ring.memory)): RingEntry[] => [...reader.read(ring.span)];
  return { ring, add, read, released, settled };
}

describe('a ring of records', () => {
  it('holds the newest, bit for bit, and tells once of each that leaves', () => {
    const sample = fc.tuple(fc.nat(3_000), fc.nat(15));
    fc.assert(
      fc.property(
        fc.array(sample, { maxLength: 60 }),
        fc.constantFrom(1, 100, 1_000, 10_000),
        (samples, blockBytes) => {
          const { ring, add, read, released } = openRing();
          const added: Uint8Array[] = [];
          for (const [length, offset] of samples) {
            const record = recordOf(added.length, length, offset);
            expect(add(record)).toBe(true);
            added.push(record);
            expect(ring.heldBytes).toBeLessThanOrEqual(CAPACITY);
          }
          const held = read(new RingReader(ring.memory, blockBytes));
          expect(held.map(({ record }) => record)).toEqual(added.slice(added.length - held.length));
          expect([...released, ...held.map(({ channel }) => channel)]).toEqual([...added.keys()]);
          expect(ring.records).toBe(held.filter(({ record }) => record.length > 0).length);
          for (const { targets, order, channel, timeMs } of held) {
            expect({ targets, order, timeMs }).toEqual({
              targets: 3,
              order: channel,
              timeMs: channel,
            });
          }
        },
      ),
      { numRuns: 200 },
    );
  });

  it('refuses a record that is larger than it may hold, and keeps the others', () => {
    const { ring, add, read } = openRing();
    add(recordOf(1, 100));
    expect(add(recordOf(2, CAPACITY))).toBe(false);
    expect(add(recordOf(3, 1_000), 1, 500)).toBe(false);
    expect(read()).toHaveLength(1);
    expect(ring.records).toBe(1);
  });

  it('overwrites what is over, some bytes at a time', () => {
    const { ring, add, read } = openRing();
    for (let i = 0; i < 20; i++) add(recordOf(7, 100), i);
    expect(ring.oldestMs).toBe(0);
    expect(ring.expire(10, 300)).toBe(true);
    expect(ring.oldestMs).toBe(3);
    expect(ring.expire(10, CAPACITY)).toBe(false);
    expect(read().map(({ timeMs }) => timeMs)).toEqual([10, 11, 12, 13, 14, 15, 16, 17, 18, 19]);
    ring.expire(Infinity, CAPACITY);
    expect(ring.oldestMs).toBeUndefined();
    expect(new Uint8Array(ring.memory.bytes).every((byte) => byte === 0)).toBe(true);
  });

  it('begins at its start again when it is empty: memory that is not needed stays untouched', () => {
    const { ring, add } = openRing();
    for (let i = 0; i < 1_000; i++) {
      add(recordOf(7, 100), i);
      ring.expire(Infinity, CAPACITY);
    }
    add(recordOf(7, 100));
    expect(new Uint8Array(ring.memory.bytes, 200).every((byte) => byte === 0)).toBe(true);
  });

  it('gives no altered record to a reader whose records are overwritten meanwhile', () => {
    const { ring, add, read } = openRing();
    const fill = (count: number): void => {
      for (let i = 0; i < count; i++) add(recordOf(ring.span.to / 8, 200, i));
    };
    const isWhole = ({ record }: RingEntry): boolean => record.every((byte) => byte === record[0]);
    fill(30);
    const reading = new RingReader(ring.memory, 1_000).read(ring.span);
    const first = [reading.next().value as RingEntry, reading.next().value as RingEntry];
    fill(20);
    const rest = [...reading];
    const all = [...first, ...rest];
    expect(all.length).toBeLessThan(30);
    expect(all.every(isWhole)).toBe(true);
    const orders = all.map(({ order }) => order);
    expect(orders).toEqual([...orders].sort((a, b) => a - b));
    expect(read().every(isWhole)).toBe(true);
  });

  it('tells of those that leave together, before their memory is used again', () => {
    const { add, settled } = openRing(64 * 1024);
    for (let i = 0; i < 400; i++) add(recordOf(i, 200));
    // An eighth of the memory leaves at once: a value that is followed by another one among them need not be kept.
    expect(Math.max(...settled.map(({ length }) => length))).toBeGreaterThan(30);
  });
});
