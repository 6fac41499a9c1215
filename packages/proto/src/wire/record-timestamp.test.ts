import { expect, it } from 'vitest';
import { DecodeError } from '../decode-error.ts';
import { encodeRecord } from '../records.ts';
import { readRecordTimestamp } from './record-timestamp.ts';

it('reads the time of an encoded record with its fraction', () => {
  const value = { x: 1, y: 2 };
  const timestampMs = 1_700_000_000_123.25;
  const record = encodeRecord({ topic: '/t', format: 'vector2', value, timestampMs });
  expect(readRecordTimestamp(record)).toBe(timestampMs);
});

it('knows no time of a record without one', () => {
  expect(readRecordTimestamp(encodeRecord({ topic: '/t', format: 'bool', value: true }))).toBe(
    undefined,
  );
});

it('refuses bytes that are no record', () => {
  const record = encodeRecord({ topic: '/topic', timestampMs: 1_700_000_000_000 });
  expect(() => readRecordTimestamp(record.subarray(0, record.length - 1))).toThrow(DecodeError);
});
