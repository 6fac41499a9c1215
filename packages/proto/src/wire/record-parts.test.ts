import fc from 'fast-check';
import { expect, it } from 'vitest';
import { TextCache } from '../binary/text-cache.ts';
import { decode, encode } from '../codec.ts';
import type { ClusterMessage, ClusterRecords } from '../generated/messages.ts';
import { arbitraryMessage } from '../testing/arbitrary-message.ts';
import { encodeRecordPart, prepareRecordsForMasters, readRecordPart } from './record-parts.ts';

const MESSAGE = 'ubii.extension.ClusterMessage';
const STREAM = 3;
const NUMBER = 70_000;

const records = arbitraryMessage(
  'ubii.extension.ClusterRecords',
) as unknown as fc.Arbitrary<ClusterRecords>;

const told: ClusterRecords = {
  records: [Uint8Array.of(1, 2, 3), new Uint8Array(2_000).fill(7), new Uint8Array(0)],
  stamps: [1.5, 2, 3],
  publishers: [0, 1, 0],
  publisherIds: ['ada', 'bö'],
};

it('encodes and reads what the codec of all messages does', () => {
  fc.assert(
    fc.property(records, fc.nat(0x7fff_ffff), fc.nat(0x7fff_ffff), (list, stream, number) => {
      const bytes = encodeRecordPart(stream, number, prepareRecordsForMasters(list));
      expect(decode(MESSAGE, bytes)).toEqual(
        decode(MESSAGE, encode(MESSAGE, { part: { stream, number, records: list } })),
      );
      expect(readRecordPart(bytes, new TextCache())).toEqual({ stream, number, records: list });
    }),
  );
});

it('sends what was prepared once to several masters, and copies no record when it reads', () => {
  const prepared = prepareRecordsForMasters(told);
  for (const stream of [1, 2]) {
    const bytes = encodeRecordPart(stream, NUMBER, prepared);
    const part = readRecordPart(bytes, new TextCache())!;
    expect(part).toEqual({ stream, number: NUMBER, records: told });
    for (const record of part.records.records) expect(record.buffer).toBe(bytes.buffer);
  }
});

it('leaves every message that has something else to the codec', () => {
  const part = { stream: STREAM, number: NUMBER, records: told };
  const others: readonly Partial<ClusterMessage>[] = [
    { listen: { stream: STREAM } },
    { goodbye: {} },
  ];
  for (const message of others) {
    expect(readRecordPart(encode(MESSAGE, message), new TextCache())).toBeUndefined();
  }
  for (const more of [{ goneClients: ['ada'] }, { sentMs: 5 }, { values: told }]) {
    const bytes = encode(MESSAGE, { part: { ...part, ...more } });
    expect(readRecordPart(bytes, new TextCache())).toBeUndefined();
  }
  const without = encode(MESSAGE, { part: { stream: STREAM, number: NUMBER } });
  expect(readRecordPart(without, new TextCache())).toBeUndefined();
  expect(readRecordPart(new Uint8Array(0), new TextCache())).toBeUndefined();
});

it('leaves what comes twice or is cut off to the codec', () => {
  const small = { ...told, records: told.records.slice(0, 1) };
  const bytes = encodeRecordPart(STREAM, NUMBER, prepareRecordsForMasters(small));
  expect(readRecordPart(Uint8Array.of(...bytes, ...bytes), new TextCache())).toBeUndefined();
  for (let length = 0; length < bytes.length; length++) {
    expect(readRecordPart(bytes.subarray(0, length), new TextCache())).toBeUndefined();
  }
});
