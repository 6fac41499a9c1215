import fc from 'fast-check';
import { expect, it } from 'vitest';
import { RecordingReader } from '../reading/recording-reader.ts';
import type { RecordedRecord } from '../records/recorded-record.ts';
import { readRecords } from '../testing/read-records.ts';
import { recorded } from '../testing/recorded.ts';
import { recordOfEachFormat, SAMPLE_HEADER, SAMPLE_START_NS } from '../testing/sample-records.ts';

it('keeps records of every data format bit for bit', async () => {
  const byFormat = recordOfEachFormat();
  const records = [...byFormat].map(([format, record], i) => ({
    topic: `/format/${format}`,
    clientId: 'ada',
    record,
    logTimeNs: SAMPLE_START_NS + BigInt(i),
    publishTimeNs: SAMPLE_START_NS - BigInt(i),
  }));
  const reader = await RecordingReader.open(await recorded(records));
  expect(await readRecords(reader)).toEqual(records);
  expect(reader.summary).toMatchObject({ ...SAMPLE_HEADER, isForeign: false, isDamaged: false });
  expect(reader.summary.topics.map(({ format }) => format)).toEqual([...byFormat.keys()]);
});

/** Texts are compared faster than bytes. */
const withText = (record: RecordedRecord) => ({
  ...record,
  record: Buffer.from(record.record).toString('base64'),
});

const anyRecord = fc.record({
  topic: fc.constantFrom('/a', '/b', '/recording/markers', '/ä'),
  clientId: fc.constantFrom('', 'ada', 'bob'),
  record: fc.oneof(
    fc.uint8Array({ maxLength: 300 }),
    fc.nat(40_000).map((length) => Uint8Array.from({ length }, (_, i) => (i * length) >>> 5)),
  ),
  logTimeNs: fc.bigInt(SAMPLE_START_NS, SAMPLE_START_NS + 5_000_000_000n),
  publishTimeNs: fc.bigInt(0n, 2n ** 63n),
});

it('gives records back by time, whatever they are and in whichever order they came', async () => {
  await fc.assert(
    fc.asyncProperty(fc.array(anyRecord, { maxLength: 100 }), async (records) => {
      const reader = await RecordingReader.open(await recorded(records));
      const wanted = records.toSorted((a, b) => Number(a.logTimeNs - b.logTimeNs));
      expect((await readRecords(reader)).map(withText)).toEqual(wanted.map(withText));
      expect(reader.summary.records).toBe(records.length);
    }),
    { numRuns: 40 },
  );
});
