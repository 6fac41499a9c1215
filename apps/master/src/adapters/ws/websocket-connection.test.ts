import { decodeTopicData, encodeRecord } from '@ubii/proto';
import { describe, expect, it } from 'vitest';

import type { RecordBatch } from '../../core/ports/index.ts';
import {
  PING_FRAME,
  PONG_FRAME,
  errorFrame,
  listFrames,
  singleFrames,
} from './websocket-connection.ts';

function batchOf(records: readonly Uint8Array[]): RecordBatch {
  const batch: RecordBatch = {
    records,
    count: records.length,
    byteLength: records.reduce((sum, { length }) => sum + length, 0),
    memo: (encoder) => encoder.encode(batch),
  };
  return batch;
}

function record(topic: string, text: string): Uint8Array {
  return encodeRecord({ topic, format: 'string', value: text });
}

/** Reads unmasked, unfragmented frames as RFC 6455 lays them out. */
function parseFrames(parts: readonly Buffer[]): { opcode: number; payload: Buffer }[] {
  const bytes = Buffer.concat(parts);
  const frames: { opcode: number; payload: Buffer }[] = [];
  for (let at = 0; at < bytes.length;) {
    const first = bytes.readUInt8(at);
    const second = bytes.readUInt8(at + 1);
    expect(first & 0xf0).toBe(0x80);
    let length = second;
    let start = at + 2;
    if (second === 126) {
      length = bytes.readUInt16BE(start);
      start += 2;
    } else if (second === 127) {
      length = Number(bytes.readBigUInt64BE(start));
      start += 8;
    }
    frames.push({ opcode: first & 0x0f, payload: bytes.subarray(start, start + length) });
    at = start + length;
  }
  return frames;
}

const BINARY = 2;
// Below and above each border of the length field, and of what is joined or left where it lies.
const sizes = [
  0, 1, 100, 124, 125, 126, 127, 1000, 16_300, 16_385, 65_500, 65_535, 65_536, 200_000,
];

describe('frames', () => {
  it.each(sizes)('[TD-3] hold one record each: %i bytes', (size) => {
    const records = [record('/a', 'x'), record('/b', 'y'.repeat(size)), record('/c', 'z')];
    const frames = parseFrames(singleFrames.encode(batchOf(records)));
    expect(frames.map(({ opcode }) => opcode)).toEqual([BINARY, BINARY, BINARY]);
    const read = frames.map(({ payload }) => decodeTopicData(payload).records);
    expect(read.map((each) => each.length)).toEqual([1, 1, 1]);
    expect(read.flat().map(({ topic }) => topic)).toEqual(['/a', '/b', '/c']);
    expect(read[1]?.[0]?.value).toBe('y'.repeat(size));
  });

  it.each(sizes)('[TD-4] hold all records as one list: %i bytes', (size) => {
    const records = [record('/a', 'x'), record('/b', 'y'.repeat(size))];
    const [frame, ...others] = parseFrames(listFrames.encode(batchOf(records)));
    expect(others).toEqual([]);
    const { records: read } = decodeTopicData(frame?.payload ?? new Uint8Array());
    expect(read.map(({ topic }) => topic)).toEqual(['/a', '/b']);
  });

  it('leave large records where they lie', () => {
    const large = record('/image', 'y'.repeat(100_000));
    const parts = singleFrames.encode(batchOf([record('/a', 'x'), large, record('/b', 'x')]));
    expect(parts).toHaveLength(3);
    expect(parts[1]?.buffer).toBe(large.buffer);
  });

  it('join small records into one piece', () => {
    const many = Array.from({ length: 64 }, (_, index) => record(`/t/${index}`, 'value'));
    expect(singleFrames.encode(batchOf(many))).toHaveLength(1);
  });

  it('[TD-17] hold an error', () => {
    const error = {
      title: 'Limit reached',
      message: 'Too many.',
      stack: '',
      code: 'internal',
      problems: [],
      join: undefined,
    };
    const [frame] = parseFrames(errorFrame(error));
    expect(decodeTopicData(frame?.payload ?? new Uint8Array()).error).toMatchObject(error);
  });

  it('[TD-2] [TD-5] hold PING and PONG as text', () => {
    expect(parseFrames(PING_FRAME)).toEqual([{ opcode: 1, payload: Buffer.from('PING') }]);
    expect(parseFrames(PONG_FRAME)).toEqual([{ opcode: 1, payload: Buffer.from('PONG') }]);
  });
});
