import { describe, expect, it } from 'vitest';
import { Publication } from './publication.ts';

/** A message of 64 bytes in the middle of memory of this size. */
function messageIn(memoryBytes: number, asBuffer: boolean): Uint8Array {
  const memory = Uint8Array.from({ length: memoryBytes }, (_, i) => i & 0xff).buffer;
  const offset = Math.floor((memoryBytes - 64) / 2);
  return asBuffer ? Buffer.from(memory, offset, 64) : new Uint8Array(memory, offset, 64);
}

describe.each([false, true])('Publication, with a buffer of the platform: %s', (asBuffer) => {
  it.each([
    ['stays where it is when it is most of its memory', 64, 4, 64, true],
    ['stays where it is when it is half of its memory', 120, 4, 64, true],
    ['is copied when it is less', 122, 4, 64, false],
    ['is copied when it is an element of a list', 64, 10, 20, false],
    ['is copied when it lies in a pool', 8192, 0, 64, false],
  ])('a kept record %s', (_, memoryBytes, start, end, stays) => {
    const publication = new Publication();
    const frame = messageIn(memoryBytes, asBuffer);
    Object.assign(publication, { frame, start, end });
    const record = publication.keepRecord();
    expect([...record]).toEqual([...frame.subarray(start, end)]);
    expect(record.constructor).toBe(Uint8Array);
    expect(record.buffer === frame.buffer).toBe(stays);
    expect(record.buffer.byteLength).toBeLessThanOrEqual(2048);
  });
});

describe('Publication', () => {
  const keep = (publication: Publication, frame: Uint8Array, start: number, end: number) => {
    Object.assign(publication, { frame, start, end });
    return publication.keepRecord();
  };

  it('keeps small records of a list next to each other, and each whole', () => {
    const publication = new Publication();
    const list = Uint8Array.from({ length: 10_000 }, (_, i) => i & 0xff);
    const records = Array.from({ length: 100 }, (_, i) =>
      keep(publication, list, i * 100, i * 100 + 99),
    );
    list.fill(0);
    records.forEach((record, i) => {
      expect([...record]).toEqual(Array.from({ length: 99 }, (_, k) => (i * 100 + k) & 0xff));
    });
    expect(new Set(records.map(({ buffer }) => buffer)).size).toBe(5);
  });

  it('gives a large record of a list memory of its own', () => {
    const record = keep(new Publication(), new Uint8Array(10_000), 0, 600);
    expect(record.buffer.byteLength).toBe(600);
  });
});
