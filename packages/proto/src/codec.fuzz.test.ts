import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { decode, encode, type MessageType } from './codec.ts';
import { DecodeError } from './decode-error.ts';
import { MESSAGES } from './descriptor.ts';
import { arbitraryMessage } from './testing/arbitrary-message.ts';
import { damagedBytes } from './testing/damaged-bytes.ts';
import { toHex } from './testing/hex.ts';

const TYPES = [...MESSAGES.keys()] as MessageType[];

describe('decode', () => {
  it.each(TYPES)('%s: what was encoded comes back', (type) => {
    fc.assert(
      fc.property(arbitraryMessage(type), (message) => {
        const bytes = encode(type, message as never);
        const decoded = decode(type, bytes);
        expect(decoded).toEqual(message);
        expect(toHex(encode(type, decoded as never))).toBe(toHex(bytes));
      }),
      { numRuns: 20 },
    );
  });

  it('throws nothing but DecodeError, and what it accepts can be encoded again', () => {
    const input = fc
      .constantFrom(...TYPES)
      .chain((type) =>
        fc.tuple(
          fc.constant(type),
          fc.oneof(
            fc.uint8Array({ maxLength: 60 }),
            damagedBytes(arbitraryMessage(type).map((message) => encode(type, message as never))),
          ),
        ),
      );
    fc.assert(
      fc.property(input, ([type, bytes]) => {
        try {
          const message = decode(type, bytes);
          const again = encode(type, message as never);
          expect(decode(type, again)).toEqual(message);
        } catch (error) {
          if (!(error instanceof DecodeError)) throw error;
        }
      }),
      { numRuns: 1000 },
    );
  });
});
