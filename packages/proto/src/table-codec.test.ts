import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { Reader } from './binary/reader.ts';
import { writeMessage } from './binary/write-message.ts';
import { GENERATED_CODECS } from './generated/codec.ts';
import { tableCodec } from './table-codec.ts';
import { arbitraryMessage } from './testing/arbitrary-message.ts';
import { damagedBytes } from './testing/damaged-bytes.ts';
import { toHex } from './testing/hex.ts';

type GeneratedType = keyof typeof GENERATED_CODECS;
const TYPES = Object.keys(GENERATED_CODECS) as GeneratedType[];

/** The result and what was read, or what was thrown. */
function outcome(decode: (reader: Reader) => unknown, bytes: Uint8Array): unknown {
  const reader = new Reader(bytes);
  try {
    return { value: decode(reader), pos: reader.pos, end: reader.end };
  } catch (error) {
    return { error: String(error), pos: reader.pos };
  }
}

describe('the table codec and the generated functions', () => {
  it.each(TYPES)('%s: write the same bytes', (type) => {
    const generated = GENERATED_CODECS[type];
    const table = tableCodec(type);
    fc.assert(
      fc.property(arbitraryMessage(type), (message) => {
        const bytes = writeMessage(generated.encode as never, message);
        expect(toHex(writeMessage(table.encode as never, message))).toBe(toHex(bytes));
      }),
      { numRuns: 20 },
    );
  });

  it.each(TYPES)(
    '%s: read the same from merged and damaged messages, and fail with the same error',
    (type) => {
      const { decode, encode } = GENERATED_CODECS[type];
      const table = tableCodec(type);
      const messages = arbitraryMessage(type).map((m) => writeMessage(encode as never, m));
      const inARow = fc
        .tuple(messages, messages)
        .map((both) => new Uint8Array(Buffer.concat(both)));
      const input = fc.oneof(fc.uint8Array({ maxLength: 60 }), damagedBytes(messages), inARow);
      fc.assert(
        fc.property(input, (bytes) => {
          const expected = outcome((reader) => decode(reader), bytes);
          expect(outcome((reader) => table.decode(reader), bytes)).toStrictEqual(expected);
        }),
        { numRuns: 60 },
      );
    },
  );

  it('throw the same kind of error on values of the wrong type', () => {
    const type = 'ubii.topicData.TopicDataRecord';
    const attempt = (encode: unknown, message: unknown): string => {
      try {
        return toHex(writeMessage(encode as never, message));
      } catch (error) {
        return (error as Error).name;
      }
    };
    const wrong = [
      [null, 'TypeError'],
      [{ topic: 5 }, 'TypeError'],
      [{ image2D: { data: [1] } }, 'TypeError'],
      [{ vector2List: { elements: 5 } }, 'TypeError'],
      [{ vector2List: { elements: [null] } }, 'TypeError'],
      [{ vector2: 5 }, '3200'],
    ] as const;
    for (const [message, result] of wrong) {
      expect(attempt(GENERATED_CODECS[type].encode, message)).toBe(result);
      expect(attempt(tableCodec(type).encode, message)).toBe(result);
    }
  });
});

describe('the table codec', () => {
  it('creates new lists and bytes for each message', () => {
    const decode = (): { data: Uint8Array } =>
      tableCodec('ubii.dataStructure.Image2D').decode(new Reader(new Uint8Array(0)));
    expect(decode().data).not.toBe(decode().data);
    const list = tableCodec('ubii.dataStructure.Int32List');
    expect(list.decode(new Reader(new Uint8Array([8, 1]))).elements).toEqual([1]);
    expect(list.decode(new Reader(new Uint8Array(0))).elements).toEqual([]);
  });

  it('knows no message that the schema does not have', () => {
    expect(() => tableCodec('ubii.nothing' as never)).toThrow(RangeError);
  });
});
