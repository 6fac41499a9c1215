import { describe, expect, it } from 'vitest';
import { mask, unmask } from './websocket-mask.ts';

const KEY = Uint8Array.of(0x12, 0xf4, 0x80, 0xff);
const BESIDE = 0xee;
const payloadOf = (length: number) => Uint8Array.from({ length }, (_, i) => (i * 31) % 256);
/** Byte by byte, as RFC 6455 has it. */
const maskedOf = (payload: Uint8Array) => payload.map((byte, i) => byte ^ KEY[i % 4]!);
/** Around what is handled in words, and each place of a payload in a word. */
const lengths = [0, 1, 3, 40, 127, 128, 129, 130, 131, 132, 147, 70_000];
const cases = lengths.flatMap((length) => [0, 1, 2, 3, 6].map((before) => [length, before]));

describe('the mask of a WebSocket frame', () => {
  it.each(cases)('is taken away from %i bytes that lie at %i, and from nothing beside', (...at) => {
    const [length, before] = at as [number, number];
    const memory = new Uint8Array(before + length + 5).fill(BESIDE);
    const frame = memory.subarray(before, before + length);
    frame.set(maskedOf(payloadOf(length)));
    unmask(frame, KEY);
    expect(Buffer.compare(frame, payloadOf(length))).toBe(0);
    const beside = [...memory.subarray(0, before), ...memory.subarray(before + length)];
    expect(new Set(beside)).toEqual(new Set([BESIDE]));
  });

  it.each(cases)('is put on %i bytes, in another buffer at %i, and in place', (...at) => {
    const [length, offset] = at as [number, number];
    const payload = payloadOf(length);
    const output = new Uint8Array(offset + length);
    mask(payload, KEY, output, offset, length);
    expect(Buffer.compare(output.subarray(offset), maskedOf(payload))).toBe(0);
    mask(payload, KEY, payload, 0, length);
    expect(Buffer.compare(payload, maskedOf(payloadOf(length)))).toBe(0);
  });
});
