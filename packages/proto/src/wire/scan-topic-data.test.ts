import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { decode, encode } from '../codec.ts';
import { DATA_FORMATS } from '../data-formats/data-formats.ts';
import type { DataFormat } from '../data-formats/data-format-values.ts';
import { DecodeError } from '../decode-error.ts';
import type { TopicDataRecord } from '../generated/messages.ts';
import { encodeRecord } from '../records.ts';
import { arbitraryMessage } from '../testing/arbitrary-message.ts';
import { createCollectingSink } from '../testing/collecting-sink.ts';
import { damagedBytes } from '../testing/damaged-bytes.ts';
import { fromHex } from '../testing/hex.ts';
import { TopicDataScan, recordValueField, scanTopicData } from './scan-topic-data.ts';

const FRAME = 'ubii.topicData.TopicData';
const RECORD = 'ubii.topicData.TopicDataRecord';
const NODE_MESSAGE = 'ubii.extension.NodeMessage';

function valueFieldOf(record: TopicDataRecord): number {
  const formats = Object.keys(DATA_FORMATS) as DataFormat[];
  const set = formats.find((format) => record[format] !== undefined);
  return set === undefined ? 0 : DATA_FORMATS[set].fieldNumber;
}

describe('scanTopicData', () => {
  it('[TD-10] hands over the records of a list in order, with topic, bounds and value field', () => {
    const records = [
      encodeRecord({ topic: '/a', format: 'vector2', value: { x: 1, y: 2 } }),
      encodeRecord({ topic: '/ä', format: 'touchEventList', value: { elements: [] } }),
      encodeRecord({ topic: '/empty' }),
    ];
    const frame = encode(FRAME, {
      topicDataRecordList: { elements: records.map((record) => decode(RECORD, record)) },
    });
    const sink = createCollectingSink();
    scanTopicData(frame, sink);
    expect(sink.records.map(({ topic, valueField }) => [topic, valueField])).toEqual([
      ['/a', 6],
      ['/ä', 34],
      ['/empty', 0],
    ]);
    for (const { start, end, topic } of sink.records) {
      expect(decode(RECORD, frame.subarray(start, end)).topic).toBe(topic);
    }
  });

  it('[TD-11] leaves the bytes of a record as they came, unknown fields and explicit zeros included', () => {
    const record = fromHex('0a012f f2ffff7f00 3209 090000000000000000 f8c10105');
    const frame = Uint8Array.from([0x12, record.length, ...record]);
    const sink = createCollectingSink();
    scanTopicData(frame, sink);
    expect(sink.records.map(({ start, end }) => frame.subarray(start, end))).toEqual([record]);
  });

  it('agrees with decode on any frame: records, topics, value fields', () => {
    fc.assert(
      fc.property(arbitraryMessage(FRAME), (message) => {
        const frame = encode(FRAME, message);
        const sink = createCollectingSink();
        scanTopicData(frame, sink);
        const { error, nodeMessage, topicDataRecord, topicDataRecordList } = decode(FRAME, frame);
        const expected =
          topicDataRecordList?.elements ?? (topicDataRecord ? [topicDataRecord] : []);
        expect(
          sink.records.map(({ start, end }) => decode(RECORD, frame.subarray(start, end))),
        ).toEqual(expected);
        expect(sink.records.map(({ topic }) => topic)).toEqual(expected.map(({ topic }) => topic));
        expect(sink.records.map(({ valueField }) => valueField)).toEqual(
          expected.map(valueFieldOf),
        );
        expect(sink.errors).toHaveLength(error === undefined ? 0 : 1);
        expect(
          sink.nodeMessages.map(({ start, end }) =>
            decode(NODE_MESSAGE, frame.subarray(start, end)),
          ),
        ).toEqual(nodeMessage === undefined ? [] : [nodeMessage]);
      }),
      { numRuns: 300 },
    );
  });

  it('[TD-12] accepts exactly the frames that decode accepts', () => {
    const frames = fc.oneof(
      fc.uint8Array({ maxLength: 60 }),
      damagedBytes(arbitraryMessage(FRAME).map((message) => encode(FRAME, message))),
    );
    fc.assert(
      fc.property(frames, (frame) => {
        expect(isAccepted(() => scanTopicData(frame, createCollectingSink()))).toBe(
          isAccepted(() => decode(FRAME, frame)),
        );
      }),
      { numRuns: 1000 },
    );
  });

  it('[TD-12] hands over the records before the one that fails, and none after', () => {
    const good = encodeRecord({ topic: '/good', format: 'double', value: 1 });
    const bad = fromHex('0a012f 3203 090000');
    const list = [good, good, bad, good].flatMap((record) => [0x0a, record.length, ...record]);
    const sink = createCollectingSink();
    expect(() => scanTopicData(Uint8Array.from([0x1a, list.length, ...list]), sink)).toThrow(
      DecodeError,
    );
    expect(sink.records.map(({ topic }) => topic)).toEqual(['/good', '/good']);
  });

  it('throws for every prefix that cuts a record', () => {
    const record = encodeRecord({
      topic: '/t',
      format: 'object3DList',
      value: { elements: [{ id: 'ä', pose: { position: { x: 1 }, euler: { z: 1 } } }] },
      timestampMs: 1763722000123,
      clientId: 'c',
    });
    const frame = Uint8Array.from([0x12, record.length, ...record]);
    for (let length = 1; length < frame.length; length++) {
      expect(() => scanTopicData(frame.subarray(0, length), createCollectingSink())).toThrow(
        DecodeError,
      );
    }
  });

  it.each([
    ['a record longer than the frame', '1205 0a'],
    ['a record of 2 GB', '12ffffffff07'],
    ['a list element longer than its list', '1a02 0a05 0000000000'],
    ['a topic that is not UTF-8', '1204 0a02c328'],
    ['a value text that is not UTF-8', '1204 2a02c328'],
    ['a client id that is not UTF-8', '1205 8a0202c328'],
    ['text that is not UTF-8 deep within', '120a 920108 0a06 0a04 0a02c328'],
    ['a nested message longer than its record', '1206 3209 09000000'],
    ['numbers of the wrong size', '1205 da0102 0a01'],
    ['groups without end', '1204 9b069b06'],
    ['field number 0', '1202 0000'],
    ['a node message longer than the frame', 'c23e05 0a'],
    ['a node message with text that is not UTF-8', 'c23e06 0a04 0a02c328'],
    ['a broken record in a node message', 'c23e07 0a05 1203 0a0561'],
  ])('throws DecodeError for %s', (_what, bytes) => {
    const frame = fromHex(bytes);
    expect(() => scanTopicData(frame, createCollectingSink())).toThrow(DecodeError);
    expect(() => decode(FRAME, frame)).toThrow(DecodeError);
  });

  it('[EX-20] [TD-12] accepts exactly the node messages that decode accepts', () => {
    const frames = damagedBytes(
      arbitraryMessage(NODE_MESSAGE).map((nodeMessage) => encode(FRAME, { nodeMessage })),
    );
    fc.assert(
      fc.property(frames, (frame) => {
        expect(isAccepted(() => scanTopicData(frame, createCollectingSink()))).toBe(
          isAccepted(() => decode(FRAME, frame)),
        );
      }),
      { numRuns: 500 },
    );
  });

  it('[EX-20] checks a node message also for a sink that has no use for it', () => {
    const records: string[] = [];
    const sink = {
      record: (topic: string) => void records.push(topic),
      error: () => undefined,
    };
    scanTopicData(fromHex('c23e02 0a00 1203 0a0161'), sink);
    expect(records).toEqual(['a']);
    expect(() => scanTopicData(fromHex('c23e06 0a04 0a02c328'), sink)).toThrow(DecodeError);
  });

  it('does not recurse along hostile nesting', () => {
    const group = fromHex('9b06'.repeat(100_000));
    expect(() => scanTopicData(group, createCollectingSink())).toThrow(DecodeError);
  });

  it('calls nothing for an empty frame and an empty list', () => {
    const sink = createCollectingSink();
    scanTopicData(new Uint8Array(0), sink);
    scanTopicData(fromHex('1a00'), sink);
    expect(sink.records).toEqual([]);
  });

  it('lets through what the sink throws, whatever it is', () => {
    const failure = new RangeError('the sink is full');
    const sink = {
      record: (): never => {
        throw failure;
      },
      error: () => undefined,
    };
    expect(() => scanTopicData(fromHex('1203 0a0161'), sink)).toThrow(failure);
  });

  it('takes Node Buffers that are views of larger memory', () => {
    const frame = Buffer.from(fromHex('ffff 1205 0a0161 2001 ff')).subarray(2, 9);
    const sink = createCollectingSink();
    scanTopicData(frame, sink);
    expect(sink.records).toEqual([{ topic: 'a', start: 2, end: 7, valueField: 4 }]);
  });
});

describe('recordValueField', () => {
  it.each(Object.values(DATA_FORMATS))(
    'finds $format',
    ({ createDefault, fieldNumber, format }) => {
      const record = encodeRecord({ topic: '/t', format, value: createDefault() } as never);
      expect(recordValueField(record)).toBe(fieldNumber);
    },
  );

  it('is 0 for a record without value', () => {
    expect(recordValueField(encodeRecord({ topic: '/t' }))).toBe(0);
  });

  it('throws DecodeError for a broken record', () => {
    expect(() => recordValueField(fromHex('0a05 61'))).toThrow(DecodeError);
  });
});

function isAccepted(read: () => unknown): boolean {
  try {
    read();
    return true;
  } catch (error) {
    if (error instanceof DecodeError) return false;
    throw error;
  }
}

describe('TopicDataScan', () => {
  const topics = Array.from({ length: 10 }, (_, i) => `/${i}`);
  const list = encode(FRAME, {
    topicDataRecordList: { elements: topics.map((topic) => ({ topic, double: 1 })) },
  });
  const frame = Uint8Array.from([...list, ...list]);

  it('[TD-71] hands over each record once when its sink pauses it after each', () => {
    const sink = createCollectingSink();
    const scan = new TopicDataScan(frame);
    const runs: string[][] = [];
    for (let isDone = false; !isDone;) {
      isDone = scan.run({
        ...sink,
        record(...found) {
          sink.record(...found);
          scan.pause();
        },
      });
      runs.push(sink.records.splice(0).map(({ topic }) => topic));
    }
    expect(runs.flat()).toEqual([...topics, ...topics]);
    expect(Math.max(...runs.map(({ length }) => length))).toBe(1);
  });

  it('[TD-71] pauses after the record with which it has read enough fields', () => {
    const sink = createCollectingSink();
    const scan = new TopicDataScan(frame);
    expect(scan.run(sink, 9)).toBe(false);
    expect(sink.records).toHaveLength(3);
    expect(scan.run(sink)).toBe(true);
    expect(sink.records).toHaveLength(20);
  });

  it('[TD-70] counts records that it steps over', () => {
    const sink = createCollectingSink();
    const scan = new TopicDataScan(frame);
    scan.run(sink, 9);
    scan.skipRecords();
    expect(scan.run(sink)).toBe(true);
    expect(sink.records).toHaveLength(3);
    expect(scan.skippedRecords).toBe(17);
  });

  it.each([
    ['nested messages', { object2DList: { elements: [{}, {}, {}, {}, {}] } }],
    ['values', { stringList: { elements: ['a', 'b', 'c', 'd', 'e'] } }],
  ])('[TD-12] refuses a record with too many %s', (_, value) => {
    const sink = createCollectingSink();
    const many = encode(FRAME, { topicDataRecord: { topic: '/a', ...value } });
    scanTopicData(many, sink);
    expect(sink.records).toHaveLength(1);
    expect(() => new TopicDataScan(many, { maxMemberFields: 6 }).run(sink)).toThrow(DecodeError);
  });

  it('[TD-12] counts unknown fields and those of groups', () => {
    const sink = createCollectingSink();
    for (const unknown of ['f80601f80601f80601', '9b069806019806019c06']) {
      const record = fromHex(`0a022f61${unknown}`);
      const one = Uint8Array.from([0x12, record.length, ...record]);
      expect(new TopicDataScan(one, { maxMemberFields: 6 }).run(sink)).toBe(true);
      expect(() => new TopicDataScan(one, { maxMemberFields: 4 }).run(sink)).toThrow('fields');
    }
  });
});
