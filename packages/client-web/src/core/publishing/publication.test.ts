import { readRecordHead } from '@ubii/proto/wire';
import { expect, it } from 'vitest';
import { endingRecord, toWaitingRecord } from './publication.ts';

const publication = {
  topic: '/a',
  format: 'double',
  value: 1,
  timestampMs: 0,
  clientId: 'ada',
} as const;

it('writes into a record how long its value outlives the client [TD-43]', () => {
  const kept = toWaitingRecord({ ...publication, keepSeconds: 600 });
  expect(readRecordHead(kept.bytes).keepSeconds).toBe(600);
  expect(readRecordHead(toWaitingRecord(publication).bytes).keepSeconds).toBe(0);
});

it('writes into a record how long its value stands [TD-47]', () => {
  const brief = toWaitingRecord({ ...publication, expiryMs: 1500 });
  expect(readRecordHead(brief.bytes)).toMatchObject({ expiryMs: 1500, keepSeconds: 0 });
});

it('refuses a time that is not a whole number', () => {
  for (const time of [-1, 0.5, NaN, 2 ** 31]) {
    expect(() => toWaitingRecord({ ...publication, keepSeconds: time })).toThrow(RangeError);
    expect(() => toWaitingRecord({ ...publication, expiryMs: time })).toThrow(RangeError);
  }
});

it('ends a topic with a record without a value, which expires at once [TD-48]', () => {
  const { bytes, isEvent } = endingRecord(publication);
  expect(readRecordHead(bytes)).toMatchObject({ topic: '/a', valueField: 0, expiryMs: 1 });
  expect(isEvent).toBe(false);
  expect(() => endingRecord({ ...publication, topic: '' })).toThrow(TypeError);
});
