import { describe, expect, expectTypeOf, it } from 'vitest';
import { decode, encode } from './codec.ts';
import { DecodeError } from './decode-error.ts';
import { ModuleEventKind, type Vector2 } from './generated/messages.ts';
import { decodeRecord, decodeTopicData, encodeRecord, type TopicRecord } from './records.ts';
import { fromHex, toHex } from './testing/hex.ts';
import {
  encodeErrorFrame,
  encodeNodeMessageFrame,
  encodeRecordListFrame,
  recordFrameHeader,
} from './wire/index.ts';

const RECORD = 'ubii.topicData.TopicDataRecord';

describe('encodeRecord and decodeRecord', () => {
  it('carry topic, value, time and publisher', () => {
    const record = {
      topic: '/a/b',
      format: 'vector2',
      value: { x: 0, y: 1 },
      timestampMs: 1763722000123.25,
      clientId: 'c',
    } as const;
    expect(decodeRecord(encodeRecord(record))).toEqual(record);
  });

  it('write what encode writes', () => {
    const bytes = encodeRecord({ topic: '/a', format: 'int32', value: -1, timestampMs: 1500 });
    const message = {
      topic: '/a',
      timestamp: { seconds: 1, nanos: 500_000_000, millis: 1500 },
      int32: -1,
    };
    expect(toHex(bytes)).toBe(toHex(encode(RECORD, message)));
  });

  it('write explicit zeros, which Unity clients need', () => {
    const bytes = encodeRecord({ topic: '/a', format: 'bool', value: false });
    expect(toHex(bytes)).toBe('0a022f612000');
  });

  it('[TD-13] carry records without a value', () => {
    expect(decodeRecord(encodeRecord({ topic: '/a' }))).toEqual({
      topic: '/a',
      format: undefined,
      value: undefined,
      timestampMs: undefined,
      clientId: '',
    });
  });

  it('carry extension formats', () => {
    const record = decodeRecord(
      encodeRecord({ topic: '/ubii/client/c', format: 'client', value: { id: 'c' } }),
    );
    expect(record).toMatchObject({ format: 'client', value: { id: 'c' } });
  });

  it('throw TypeError for a format without value', () => {
    expect(() =>
      encodeRecord({ topic: '/a', format: 'vector2', value: undefined as never }),
    ).toThrow('the record on /a has no vector2 value');
  });

  it('throw DecodeError for what is no record', () => {
    expect(() => decodeRecord(fromHex('0a05 61'))).toThrow(DecodeError);
  });

  it('are typed by format', () => {
    const record = decodeRecord(encodeRecord({ topic: '/a', format: 'vector2', value: {} }));
    if (record.format === 'vector2') expectTypeOf(record.value).toEqualTypeOf<Vector2>();
    if (record.format === undefined) expectTypeOf(record.value).toEqualTypeOf<undefined>();
    expectTypeOf<TopicRecord<'double' | 'string'>['value']>().toEqualTypeOf<number | string>();
    // @ts-expect-error the value of another format
    encodeRecord({ topic: '/a', format: 'vector2', value: 'text' } satisfies TopicRecord);
  });
});

describe('decodeTopicData', () => {
  const good = encodeRecord({ topic: '/good', format: 'double', value: 1 });
  const bad = fromHex('0a012f 3203 090000');

  it('reads a single record', () => {
    const frame = Uint8Array.from([...recordFrameHeader(good.length), ...good]);
    expect(decodeTopicData(frame)).toMatchObject({
      records: [{ topic: '/good', value: 1 }],
      error: undefined,
      failed: [],
    });
  });

  it('does not lose the other records of a list because of a bad one', () => {
    const { records, failed } = decodeTopicData(encodeRecordListFrame([good, bad, good]));
    expect(records.map(({ topic }) => topic)).toEqual(['/good', '/good']);
    expect(failed).toHaveLength(1);
    expect(failed[0]).toMatchObject({ messageType: RECORD, byteLength: bad.length });
  });

  it('reads an error', () => {
    const { error, records } = decodeTopicData(encodeErrorFrame({ title: 't', code: 'not_found' }));
    expect(error).toEqual({ title: 't', message: '', stack: '', code: 'not_found', problems: [] });
    expect(records).toEqual([]);
  });

  it('[EX-20] reads node messages, and a broken one loses nothing else', () => {
    const report = encodeNodeMessageFrame({
      moduleReports: { events: [{ sessionId: 's', moduleName: 'm', message: 'it failed' }] },
    });
    const broken = fromHex('c23e06 0a04 0a02c328');
    const single = [...recordFrameHeader(good.length), ...good];
    const { records, nodeMessages, failed, error } = decodeTopicData(
      Uint8Array.from([...report, ...broken, ...report, ...single]),
    );
    expect(nodeMessages).toHaveLength(2);
    expect(nodeMessages[1]?.moduleReports?.events).toMatchObject([
      { sessionId: 's', moduleName: 'm', message: 'it failed', kind: ModuleEventKind.ERROR },
    ]);
    expect(records.map(({ topic }) => topic)).toEqual(['/good']);
    expect(failed).toMatchObject([{ messageType: 'ubii.extension.NodeMessage', byteLength: 6 }]);
    expect(error).toBeUndefined();
  });

  it('has no node messages in other frames', () => {
    expect(decodeTopicData(encodeRecordListFrame([good])).nodeMessages).toEqual([]);
  });

  it('keeps the records before the frame breaks, and says that it broke', () => {
    const frame = encodeRecordListFrame([good, good]);
    const { records, failed } = decodeTopicData(frame.subarray(0, frame.length - 3));
    expect(records).toHaveLength(0);
    expect(failed).toHaveLength(1);
    const cut = Uint8Array.from([...recordFrameHeader(good.length), ...good, 0x12, 0x7f]);
    expect(decodeTopicData(cut)).toMatchObject({
      records: [{ topic: '/good' }],
      failed: [{ messageType: 'ubii.topicData.TopicData' }],
    });
  });

  it('agrees with decode', () => {
    const frame = encodeRecordListFrame([good, good]);
    const list = decode('ubii.topicData.TopicData', frame).topicDataRecordList;
    expect(decodeTopicData(frame).records.map(({ topic }) => topic)).toEqual(
      list?.elements.map(({ topic }) => topic),
    );
  });
});
