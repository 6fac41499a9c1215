import { describe, expect, it } from 'vitest';

import { FrameReader } from './frame-reader.ts';
import { DELIMITER, ZmtpError, encodeCommand, encodeFrame } from './zmtp-frames.ts';

const MAX_BYTES = 1_000;

/** What a reader finds in these chunks: bodies as text, with `+` where more follows and `!` for commands. */
function found(chunks: readonly Uint8Array[]): string[] {
  const reader = new FrameReader(MAX_BYTES);
  const frames: string[] = [];
  for (const chunk of chunks) {
    reader.read(Buffer.from(chunk), ({ isCommand, hasMore }, bytes, start, end) => {
      const text = bytes.toString('latin1', start, end);
      frames.push(`${text}${hasMore ? '+' : ''}${isCommand ? '!' : ''}`);
    });
  }
  return frames;
}

const sent = Buffer.concat([
  DELIMITER,
  encodeFrame(Buffer.from('short')),
  encodeCommand('PING', Buffer.from('xx')),
  encodeFrame(Buffer.alloc(300, 'l')),
  encodeFrame(Buffer.alloc(0)),
]);
const expected = ['+', 'short', '\x04PINGxx!', 'l'.repeat(300), ''];

describe('frames of ZMTP', () => {
  it('are found in one piece', () => {
    expect(found([sent])).toEqual(expected);
  });

  it.each(Array.from({ length: sent.length - 1 }, (_, i) => i + 1))(
    'are found in two pieces, cut at byte %i',
    (at) => {
      expect(found([sent.subarray(0, at), sent.subarray(at)])).toEqual(expected);
    },
  );

  it('are found byte by byte', () => {
    expect(found([...sent].map((byte) => Uint8Array.of(byte)))).toEqual(expected);
  });

  it('may have the most bytes and no more, which is known from the header', () => {
    expect(found([encodeFrame(Buffer.alloc(MAX_BYTES, 'x'))])).toEqual(['x'.repeat(MAX_BYTES)]);
    const header = encodeFrame(Buffer.alloc(MAX_BYTES + 1)).subarray(0, 9);
    expect(() => found([header])).toThrow('A message may have at most 1000 bytes.');
    expect(() => found([Buffer.from([2, ...Array<number>(8).fill(0xff)])])).toThrow(ZmtpError);
  });

  it('have less when they are commands, which is known from the header [TD-53]', () => {
    const long = (size: number): Buffer => {
      const header = Buffer.alloc(9);
      header[0] = 0x06;
      header.writeUInt32BE(size, 5);
      return header;
    };
    expect(() => found([long(256)])).toThrow('A command may have at most 255 bytes.');
    expect(found([long(255), Buffer.alloc(255, 'c')])).toEqual([`${'c'.repeat(255)}!`]);
  });

  it.each([0x08, 0x80, 0xff, 0x05, 0x07])('have no flags %i', (flags) => {
    expect(() => found([Uint8Array.of(flags)])).toThrow(`unknown flags ${flags}`);
  });
});
