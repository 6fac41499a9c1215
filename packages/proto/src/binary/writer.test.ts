import { describe, expect, it } from 'vitest';
import { decode, encode } from '../codec.ts';
import { fromHex, toHex } from '../testing/hex.ts';
import { Reader } from './reader.ts';
import { writeMessage } from './write-message.ts';
import { Writer } from './writer.ts';

function written(write: (writer: Writer) => void): Uint8Array {
  const writer = new Writer();
  write(writer);
  return writer.finish();
}

describe('Writer', () => {
  it.each([0, 1, 127, 128, 16_383, 16_384, 2_097_151, 2_097_152])(
    'puts the length before a nested message of %i bytes',
    (length) => {
      const bytes = written((writer) => {
        const outer = writer.open(10);
        const inner = writer.open(18);
        if (length > 0) writer.bytes(26, new Uint8Array(length));
        writer.close(inner);
        writer.bool(32, true);
        writer.close(outer);
      });
      const reader = new Reader(bytes);
      expect(reader.tag()).toBe(10);
      reader.enter();
      expect(reader.end).toBe(bytes.length);
      expect(reader.tag()).toBe(18);
      reader.skip(reader.length());
      expect([reader.tag(), reader.bool()]).toEqual([32, true]);
      expect(reader.pos).toBe(bytes.length);
    },
  );

  it.each([
    ['', '0a00'],
    ['a', '0a0161'],
    ['ä', '0a02c3a4'],
    ['€', '0a03e282ac'],
    ['😀', '0a04f09f9880'],
    ['\ud83d', '0a03efbfbd'],
  ])('writes the text %j', (text, bytes) => {
    expect(toHex(written((writer) => writer.string(10, text)))).toBe(bytes);
  });

  it.each([23, 24, 25, 126, 127, 128, 5000, 400_000])(
    'writes text of %i characters, ASCII or not',
    (length) => {
      for (const character of ['x', 'ä', '€']) {
        const text = `${'x'.repeat(length - 1)}${character}`;
        expect(new Reader(written((writer) => writer.string(10, text)).subarray(1)).string()).toBe(
          text,
        );
      }
    },
  );

  it.each([
    [0, '0800'],
    [127, '087f'],
    [128, '088001'],
    [2 ** 31 - 1, '08ffffffff07'],
    [-1, '08ffffffffffffffffff01'],
    [-(2 ** 31), '0880808080f8ffffffff01'],
  ])('writes the 32-bit integer %i', (value, bytes) => {
    expect(toHex(written((writer) => writer.int32(8, value)))).toBe(bytes);
  });

  it.each([
    [0, '0800'],
    [2 ** 32, '088080808010'],
    [2 ** 53 - 1, '08ffffffffffffff0f'],
    [-1, '08ffffffffffffffffff01'],
    [-(2 ** 63), '0880808080808080808001'],
    [1.9, '0801'],
    [-1.9, '08ffffffffffffffffff01'],
  ])('writes the 64-bit integer %d', (value, bytes) => {
    expect(toHex(written((writer) => writer.int64(8, value)))).toBe(bytes);
  });

  it('gives away what it wrote: later writing does not change it', () => {
    const writer = new Writer();
    writer.string(10, 'first');
    const first = writer.finish();
    writer.string(10, 'other');
    expect(new Reader(first.subarray(1)).string()).toBe('first');
    expect(first.buffer.byteLength).toBe(first.length);
    expect(writer.finish()).toHaveLength(7);
  });
});

describe('Reader', () => {
  it('reads what ends exactly at the end, and nothing beyond', () => {
    const reader = new Reader(fromHex('08 ff'));
    reader.end = 1;
    expect(reader.tag()).toBe(8);
    expect(() => reader.bool()).toThrow('what starts at byte 1 does not end before byte 1');
  });

  it('leaves the position where a value that fails begins', () => {
    const reader = new Reader(fromHex('ffff'));
    expect(() => reader.int32()).toThrow();
    expect(reader.pos).toBe(0);
  });
});

describe('writeMessage', () => {
  it('encodes within the encoding of another message', () => {
    const outer = {
      get name(): string {
        return String(encode('ubii.clients.Client', { id: 'inner' }).length);
      },
      id: 'outer',
    };
    expect(decode('ubii.clients.Client', encode('ubii.clients.Client', outer))).toMatchObject({
      id: 'outer',
      name: '7',
    });
  });

  it('is not disturbed by an encoding that failed', () => {
    expect(() =>
      writeMessage((_message, writer) => {
        writer.open(10);
        throw new Error('failed');
      }, {}),
    ).toThrow('failed');
    expect(toHex(encode('ubii.clients.Client', { id: 'a' }))).toBe('0a0161');
  });
});
