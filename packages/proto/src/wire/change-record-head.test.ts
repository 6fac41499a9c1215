import { expect, it } from 'vitest';
import { encode, decode } from '../codec.ts';
import { DecodeError } from '../decode-error.ts';
import { encodeRecord } from '../records.ts';
import { timestampFromMs } from '../timestamp.ts';
import { changeRecordHead } from './change-record-head.ts';

const TYPE = 'ubii.topicData.TopicDataRecord';
const before = {
  topic: '/a',
  timestamp: timestampFromMs(1_700_000_000_000),
  clientId: 'ada',
  extension: { keepSeconds: 5 },
  vector3: { x: 1, y: 2, z: 3 },
};

it('replaces topic, timestamp and client id, and nothing else', () => {
  const changed = changeRecordHead(encode(TYPE, before), {
    topic: '/longer/ä',
    timeMs: 1_800_000_000_123,
    clientId: 'ghost',
  });
  const after = {
    ...before,
    topic: '/longer/ä',
    timestamp: timestampFromMs(1_800_000_000_123),
    clientId: 'ghost',
  };
  expect(decode(TYPE, changed)).toEqual(decode(TYPE, encode(TYPE, after)));
});

it('gives a record no timestamp and no client id that had none', () => {
  const record = encodeRecord({ topic: '/a', format: 'double', value: 1 });
  const changed = changeRecordHead(record, {
    topic: '/b',
    timeMs: 1_800_000_000_000,
    clientId: 'x',
  });
  expect(changed).toEqual(encodeRecord({ topic: '/b', format: 'double', value: 1 }));
});

it('returns the record itself when nothing changes', () => {
  const record = encode(TYPE, before);
  expect(changeRecordHead(record, {})).toBe(record);
});

it('keeps fields that the schema does not have, and one topic of several', () => {
  const twice = Uint8Array.from([...encode(TYPE, { topic: '/x' }), ...encode(TYPE, before)]);
  const unknown = Uint8Array.from([...twice, 0xf8, 0xff, 0x07, 0x2a]);
  const changed = changeRecordHead(unknown, { topic: '/b' });
  expect(decode(TYPE, changed)).toEqual(decode(TYPE, encode(TYPE, { ...before, topic: '/b' })));
  expect([...changed.subarray(-4)]).toEqual([0xf8, 0xff, 0x07, 0x2a]);
});

it('refuses bytes that are no record', () => {
  const record = encode(TYPE, before);
  const cut = record.subarray(0, record.length - 1);
  expect(() => changeRecordHead(cut, { topic: '/b' })).toThrow(DecodeError);
});
