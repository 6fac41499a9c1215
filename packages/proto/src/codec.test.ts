import { describe, expect, expectTypeOf, it } from 'vitest';
import { decode, encode, isMessageType, type MessageType } from './codec.ts';
import { DecodeError } from './decode-error.ts';
import { MESSAGES } from './descriptor.ts';
import {
  ClientState,
  type Client,
  type TopicDataRecord,
  type Vector2,
} from './generated/messages.ts';
import { fromHex, toHex } from './testing/hex.ts';

const RECORD = 'ubii.topicData.TopicDataRecord';

/** Bytes written by hand from the wire format; conformance.test.ts compares with the published module. */
const GOLDEN = [
  [
    'ubii.topicData.Timestamp',
    { seconds: 1, nanos: -1, millis: 1000 },
    '0801 10ffffffffffffffffff01 18e807',
  ],
  ['ubii.dataStructure.Vector2', { x: 1, y: -2 }, '09000000000000f03f 1100000000000000c0'],
  ['ubii.dataStructure.Color', { a: 1 }, '21000000000000f03f'],
  ['ubii.dataStructure.KeyEvent', { type: 1, key: 'ä' }, '0801 1202c3a4'],
  ['ubii.dataStructure.Int32List', { elements: [1, -1, 300] }, '0a0d 01ffffffffffffffffff01ac02'],
  ['ubii.dataStructure.BoolList', { elements: [true, false] }, '0a020100'],
  ['ubii.dataStructure.FloatList', { elements: [0.5] }, '0a040000003f'],
  ['ubii.dataStructure.StringList', { elements: ['a', ''] }, '0a0161 0a00'],
  [
    'ubii.dataStructure.Image2D',
    { width: 1, height: 1, dataFormat: 1, data: new Uint8Array([1, 2, 3]) },
    '0801 1001 1801 2203010203',
  ],
  ['ubii.clients.Client', { id: 'c', state: 2, latency: 1.5 }, '0a0163 5002 5d0000c03f'],
  ['ubii.clients.Client', { extension: { recordLists: true } }, 'c23e02 0801'],
  ['ubii.general.Error', { title: 't', code: 'internal' }, '0a0174 c23e08696e7465726e616c'],
  [
    'ubii.services.ServiceRequest',
    { topic: '/t', topicSubscription: { clientId: 'c', subscribeTopics: ['/a'], maxRateHz: 10 } },
    '0a022f74 2211 0a0163 12022f61 c13e0000000000002440',
  ],
  [
    RECORD,
    { topic: '/a', timestamp: { millis: 5 }, vector2: { x: 0, y: 0 } },
    '0a022f61 12021805 3212 090000000000000000 110000000000000000',
  ],
  ['ubii.topicData.TopicData', { topicDataRecord: { topic: 'a', bool: true } }, '1205 0a0161 2001'],
] as const satisfies readonly (readonly [MessageType, object, string])[];

describe('encode and decode', () => {
  it.each(GOLDEN)('%s %j', (type, message, bytes) => {
    expect(toHex(encode(type, message as never))).toBe(toHex(fromHex(bytes)));
    expect(decode(type, fromHex(bytes))).toMatchObject(message);
  });

  it('write zeros that were given, as the original does: Unity keeps the value before otherwise', () => {
    expect(toHex(encode('ubii.dataStructure.Vector2', { x: 0 }))).toBe('090000000000000000');
    expect(toHex(encode(RECORD, { topic: '', bool: false }))).toBe('0a002000');
    expect(toHex(encode(RECORD, { double: 0 }))).toBe('190000000000000000');
  });

  it('leave out what was not given', () => {
    expect(encode('ubii.clients.Client', {})).toHaveLength(0);
    expect(encode('ubii.clients.Client', { id: undefined, name: null, tags: [] })).toHaveLength(0);
  });

  it('leave out the language 0, at which existing nodes exit', () => {
    expect(encode('ubii.processing.ProcessingModule', { language: 0 })).toHaveLength(0);
    expect(toHex(encode('ubii.processing.ProcessingModule', { language: 2 }))).toBe('6002');
  });

  it('give plain objects: defaults and lists always there, absent messages undefined', () => {
    const client = decode('ubii.clients.Client', new Uint8Array(0));
    expect(client).toStrictEqual({
      id: '',
      name: '',
      devices: [],
      tags: [],
      description: '',
      processingModules: [],
      isDedicatedProcessingNode: false,
      hostIp: '',
      metadataJson: '',
      state: 0,
      latency: 0,
      extension: undefined,
    });
    expect(Object.getPrototypeOf(client)).toBe(Object.prototype);
    expect(structuredClone(client)).toStrictEqual(client);
  });

  it('give plain byte arrays for Node Buffers too', () => {
    const bytes = Buffer.from(encode('ubii.dataStructure.Image2D', { data: new Uint8Array([7]) }));
    const { data } = decode('ubii.dataStructure.Image2D', bytes);
    expect(data.constructor).toBe(Uint8Array);
    expect([...data]).toEqual([7]);
  });

  it('take the bytes of a canvas', () => {
    const data = new Uint8ClampedArray([1, 255]);
    expect(toHex(encode('ubii.dataStructure.Image2D', { data }))).toBe('220201ff');
  });

  it('read members of class instances, which may be accessors of the class', () => {
    class Point {
      get x(): number {
        return 1;
      }
      get y(): number {
        return 2;
      }
    }
    expect(toHex(encode('ubii.dataStructure.Vector2', new Point()))).toBe(
      toHex(encode('ubii.dataStructure.Vector2', { x: 1, y: 2 })),
    );
  });

  it('throw on text and bytes that are none, which the writer would silently drop', () => {
    expect(() => encode(RECORD, { topic: 5 as never })).toThrow(TypeError);
    expect(() => encode('ubii.dataStructure.Image2D', { data: [1] as never })).toThrow(TypeError);
  });

  it('write half a surrogate pair as U+FFFD, so that every text can be read again', () => {
    const bytes = encode(RECORD, { topic: 'a\ud800b\udc00\ud83d\ude00' });
    expect(decode(RECORD, bytes).topic).toBe('a\ufffdb\ufffd\ud83d\ude00');
  });

  it('keep 64-bit integers as numbers, up to 2^53 exactly', () => {
    for (const millis of [0, -1, 1763722000123, -(2 ** 40) - 5, 2 ** 53 - 1, -(2 ** 53) + 1]) {
      const bytes = encode('ubii.topicData.Timestamp', { millis });
      expect(decode('ubii.topicData.Timestamp', bytes).millis).toBe(millis);
    }
    const smallest = decode('ubii.topicData.Timestamp', fromHex('1880808080808080808001'));
    expect(smallest.millis).toBe(-(2 ** 63));
  });

  it('keep enum numbers the schema does not know', () => {
    expect(decode('ubii.clients.Client', fromHex('5063')).state).toBe(99);
  });
});

describe('decode, by the rules of the wire format', () => {
  it('skips unknown fields of every kind', () => {
    const unknown = 'b80601 b90601 02030405060708 ba0602 ffff bd0601020304 bb06 0801 bc06';
    const bytes = fromHex(`0a0163 ${unknown} 120178`);
    expect(decode('ubii.clients.Client', bytes)).toMatchObject({ id: 'c', name: 'x' });
  });

  it('skips a known field that comes with another wire type', () => {
    expect(decode('ubii.clients.Client', fromHex('0863 120178'))).toMatchObject({
      id: '',
      name: 'x',
    });
  });

  it('takes the last of a repeated scalar and merges repeated messages', () => {
    const twice = fromHex('0a0161 0a0162 1202 0801 1202 1002');
    expect(decode(RECORD, twice)).toMatchObject({
      topic: 'b',
      timestamp: { seconds: 1, nanos: 2, millis: 0 },
    });
  });

  it('takes the last member of a oneof, merging it when it is the same', () => {
    const different = decode(RECORD, fromHex('2001 190000000000000000'));
    expect(different).toStrictEqual({
      topic: '',
      timestamp: undefined,
      clientId: '',
      extension: undefined,
      double: 0,
    });
    const same = decode(RECORD, fromHex('3209 09000000000000f03f 3209 11000000000000f03f'));
    expect(same.vector2).toEqual({ x: 1, y: 1 });
  });

  it('takes the last member of a oneof across merged messages', () => {
    const pose = decode('ubii.dataStructure.Object2D', fromHex('1202 1200 1205 1d0000803f'));
    expect(pose.pose).toStrictEqual({ position: undefined, angle: 1 });
  });

  it('reads lists of numbers packed, unpacked and mixed', () => {
    const mixed = fromHex('0801 0a020203 0804');
    expect(decode('ubii.dataStructure.Int32List', mixed).elements).toEqual([1, 2, 3, 4]);
  });
});

describe('decode of hostile input', () => {
  const whole = encode('ubii.services.ServiceRequest', {
    topic: '/services/client/registration',
    client: {
      id: 'id',
      name: 'näme',
      devices: [{ name: 'd', components: [{ topic: '/t', tags: ['a', 'b'] }] }],
      processingModules: [{ processingMode: { frequency: { hertz: 30 } } }],
      latency: 1,
    },
  });

  it('throws DecodeError, or yields less, for every prefix', () => {
    for (let length = 0; length < whole.length; length++) {
      const prefix = whole.subarray(0, length);
      try {
        const { topic, client } = decode('ubii.services.ServiceRequest', prefix);
        expect(topic === '' || client === undefined).toBe(true);
      } catch (error) {
        expect(error).toBeInstanceOf(DecodeError);
      }
    }
  });

  it.each([
    ['a length beyond the end', '0a05 61'],
    ['a length of 2 GB', '0affffffff07'],
    ['a length of more than 31 bits', '0affffffff0f'],
    ['a member that ends after its message', '1a03 0a0561'],
    ['a tag of more than 32 bits', '8080808010 00'],
    ['a number of 11 bytes', '50ffffffffffffffffffff01'],
    ['an unknown number of 11 bytes', '98 06 ffffffffffffffffffff01'],
    ['field number 0', '0000'],
    ['wire type 6', '0e'],
    ['wire type 7', '0f'],
    ['a group that ends without a start', '0c'],
    ['a group that does not end', '9b06'],
    ['a group that ends as another', '9b06a406'],
    ['text that is not UTF-8', '0a02c328'],
    ['text with a surrogate', '0a03eda080'],
    ['text in overlong form', '0a02c080'],
    ['text cut within a character', '0a01c3'],
  ])('throws DecodeError for %s', (_what, bytes) => {
    expect(() => decode('ubii.clients.Client', fromHex(bytes))).toThrow(DecodeError);
  });

  it('throws DecodeError for groups nested deeper than 100', () => {
    const nested = (depth: number): Uint8Array =>
      fromHex('9b06'.repeat(depth) + '9c06'.repeat(depth));
    expect(() => decode('ubii.clients.Client', nested(100))).not.toThrow();
    expect(() => decode('ubii.clients.Client', nested(101))).toThrow(DecodeError);
    expect(() => decode('ubii.clients.Client', nested(100_000))).toThrow(DecodeError);
  });

  it('throws DecodeError for lists whose bytes are no whole number of elements', () => {
    expect(() => decode('ubii.dataStructure.DoubleList', fromHex('0a07 00000000000000'))).toThrow(
      DecodeError,
    );
    expect(() => decode('ubii.dataStructure.FloatList', fromHex('0a03 000000'))).toThrow(
      DecodeError,
    );
  });

  it('throws DecodeError for more messages than honest ones hold, which would fill the memory', () => {
    const empties = (count: number): Uint8Array =>
      new Uint8Array(2 * count).map((_byte, i) => (i % 2 === 0 ? 0x0a : 0));
    const points = decode('ubii.dataStructure.Vector2List', empties(640 * 480));
    expect(points.elements).toHaveLength(640 * 480);
    expect(() => decode('ubii.clients.ClientList', empties(400_001))).toThrow(
      'more than 400000 messages within one',
    );
  });

  it('says what was expected, how much there was and why it failed', () => {
    let error: unknown;
    try {
      decode('ubii.clients.Client', fromHex('0a0561'));
    } catch (thrown) {
      error = thrown;
    }
    expect(error).toMatchObject({
      name: 'DecodeError',
      messageType: 'ubii.clients.Client',
      byteLength: 3,
      cause: expect.any(Error) as unknown,
    });
    expect((error as Error).message).toContain('3 bytes cannot be read as ubii.clients.Client');
  });
});

describe('the types', () => {
  it('know every message', () => {
    expect([...MESSAGES.keys()].every(isMessageType)).toBe(true);
    expect(isMessageType('ubii.nothing')).toBe(false);
    expect(isMessageType('__proto__')).toBe(false);
  });

  it('follow the name of the message', () => {
    expectTypeOf(decode<'ubii.clients.Client'>).returns.toEqualTypeOf<Client>();
    expectTypeOf<TopicDataRecord['vector2']>().toEqualTypeOf<Vector2 | undefined>();
    expectTypeOf<Client['state']>().toEqualTypeOf<0 | 1 | 2>();
    expectTypeOf(ClientState.UNAVAILABLE).toEqualTypeOf<2>();
    // @ts-expect-error a member of another message
    encode('ubii.dataStructure.Vector2', { z: 1 });
    // @ts-expect-error no such message
    expect(() => encode('ubii.dataStructure.Vector9', {})).toThrow();
  });
});
