import { describe, expect, it } from 'vitest';

import { FrameError, FrameReader, clientFrame, serverFrame } from './frames.ts';

function readAll(chunks: readonly Buffer[]): { payloads: string[]; isAtBoundary: boolean } {
  const payloads: string[] = [];
  const reader = new FrameReader((_opcode, bytes, start, end) => {
    payloads.push(bytes.toString('latin1', start, end));
  });
  for (const chunk of chunks) reader.push(chunk);
  return { payloads, isAtBoundary: reader.isAtBoundary };
}

describe('FrameReader', () => {
  const texts = ['', 'one', 'b'.repeat(125), 'c'.repeat(126), 'd'.repeat(70_000)];
  const huge = Buffer.concat([
    Buffer.from([0x82, 127, 0, 0, 0, 0, 0, 1, 0x11, 0x70]),
    Buffer.from(texts[4]!),
  ]);
  const stream = Buffer.concat([
    ...texts.slice(0, 4).map((t) => serverFrame(Buffer.from(t))),
    huge,
  ]);

  it('reads every length form', () => {
    expect(readAll([stream])).toEqual({ payloads: texts, isAtBoundary: true });
  });

  it('reads the same wherever the stream is cut', () => {
    const cuts = [
      1,
      2,
      3,
      5,
      8,
      130,
      131,
      132,
      133,
      134,
      260,
      261,
      265,
      270,
      300,
      stream.length - 1,
    ];
    for (const cut of cuts) {
      const chunks = [stream.subarray(0, cut), stream.subarray(cut)];
      expect(readAll(chunks), `cut at ${cut}`).toEqual({ payloads: texts, isAtBoundary: true });
    }
    const bytewise = Array.from(stream.subarray(0, 300), (byte) => Buffer.from([byte]));
    expect(readAll(bytewise).payloads).toEqual(texts.slice(0, 4));
  });

  it('keeps an incomplete frame, whatever becomes of the chunk', () => {
    const payloads: string[] = [];
    const reader = new FrameReader((_opcode, bytes, start, end) => {
      payloads.push(bytes.toString('latin1', start, end));
    });
    const frame = serverFrame(Buffer.from('kept'));
    const chunk = Buffer.from(frame.subarray(0, 4));
    reader.push(chunk);
    chunk.fill(0);
    expect(reader.isAtBoundary).toBe(false);
    reader.push(frame.subarray(4));
    expect(payloads).toEqual(['kept']);
  });

  it('refuses what no server may send', () => {
    expect(() => readAll([clientFrame(2, Buffer.from('masked'))])).toThrow(FrameError);
    expect(() => readAll([Buffer.from([0x02, 1, 65])])).toThrow(FrameError);
  });
});
