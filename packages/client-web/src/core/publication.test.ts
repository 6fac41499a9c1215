import { readRecordHead } from '@ubii/proto/wire';
import { expect, it } from 'vitest';
import { toWaitingRecord } from './publication.ts';

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

it('refuses a time that is not a whole number of seconds', () => {
  for (const keepSeconds of [-1, 0.5, NaN, 2 ** 31]) {
    expect(() => toWaitingRecord({ ...publication, keepSeconds })).toThrow(RangeError);
  }
});
