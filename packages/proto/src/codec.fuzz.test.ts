import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import fc from 'fast-check';
import protobuf from 'protobufjs';
import { describe, expect, it } from 'vitest';
import { decode, encode, type MessageType } from './codec.ts';
import { DecodeError } from './decode-error.ts';
import { MESSAGES } from './descriptor.ts';
import { arbitraryMessage } from './testing/arbitrary-message.ts';
import { damagedBytes } from './testing/damaged-bytes.ts';
import { toHex } from './testing/hex.ts';

const SCHEMA_FOLDER = join(fileURLToPath(import.meta.url), '..', '..', 'schema');
const TYPES = [...MESSAGES.keys()] as MessageType[];

/** The independent implementation that the results are compared with. */
const reference = new protobuf.Root();
reference.resolvePath = (_origin, target) => join(SCHEMA_FOLDER, target.replace(SCHEMA_FOLDER, ''));
reference.loadSync(
  readdirSync(SCHEMA_FOLDER, { recursive: true, encoding: 'utf8' }).filter((file) =>
    file.endsWith('.proto'),
  ),
);

// In a message without fields protobufjs takes the tag for the field number, and so misses field
// number 0 and the ends of groups. A field that is never sent keeps it from that.
for (const type of TYPES.map((name) => reference.lookupType(name))) {
  if (type.fieldsArray.length > 0) continue;
  const unsent = new protobuf.Field('unsent', 536_870_911, 'bool');
  type.add(new protobuf.OneOf('never').add(unsent));
}

/** How protobufjs makes plain objects as ours are. */
const PLAIN = { defaults: true, arrays: true, longs: Number };

function concat(parts: readonly Uint8Array[]): Uint8Array {
  return new Uint8Array(Buffer.concat(parts));
}

/** Absent members left out, bytes plain: protobufjs marks absence with null. */
function comparable(value: unknown): unknown {
  if (value instanceof Uint8Array) return [...value];
  if (Array.isArray(value)) return value.map(comparable);
  if (typeof value !== 'object' || value === null) return value;
  return Object.fromEntries(
    Object.entries(value)
      .filter(([, member]) => member !== undefined && member !== null)
      .map(([key, member]) => [key, comparable(member)]),
  );
}

function attempt<T>(read: () => T): { value: T } | { error: unknown } {
  try {
    return { value: read() };
  } catch (error) {
    return { error };
  }
}

/** Random bytes, and messages with damage. */
const input = fc.oneof(
  ...TYPES.map((type) =>
    fc.tuple(
      fc.constant(type),
      fc.oneof(
        fc.uint8Array({ maxLength: 60 }),
        damagedBytes(arbitraryMessage(type).map((message) => encode(type, message as never))),
      ),
    ),
  ),
);

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

  it.each(TYPES)('%s: protobufjs reads what we write, and we read what it writes', (type) => {
    const theirs = reference.lookupType(type);
    const read = (bytes: Uint8Array): object => theirs.toObject(theirs.decode(bytes), PLAIN);
    const write = (message: object): Uint8Array =>
      theirs.encode(theirs.fromObject(message)).finish();
    fc.assert(
      fc.property(arbitraryMessage(type), arbitraryMessage(type), (first, second) => {
        const ours = [first, second].map((message) => encode(type, message as never));
        expect(decode(type, write(first))).toEqual(first);
        expect(comparable(read(ours[0]!))).toEqual(comparable(first));
        // Two messages in a row are one: lists grow, messages merge, the rest is replaced.
        for (const both of [concat(ours), concat([first, second].map(write))]) {
          expect(comparable(decode(type, both))).toEqual(comparable(read(both)));
        }
      }),
      { numRuns: 20 },
    );
  });

  it('throws nothing but DecodeError, and what it accepts can be encoded again', () => {
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

  it('accepts what protobufjs accepts, and gives the same, merging and all', () => {
    fc.assert(
      fc.property(input, ([type, bytes]) => {
        const ours = attempt(() => decode(type, bytes));
        const theirs = attempt(() => {
          const message = reference.lookupType(type);
          return message.toObject(message.decode(bytes), PLAIN);
        });
        if ('error' in ours) {
          // protobufjs skips unknown numbers of any length; ours, like others, stops after 10 bytes.
          if (String(ours.error).includes('too long')) return;
          expect(theirs).toHaveProperty('error');
        } else {
          expect(theirs).not.toHaveProperty('error');
          if ('value' in theirs) expect(comparable(ours.value)).toEqual(comparable(theirs.value));
        }
      }),
      { numRuns: 1000 },
    );
  });
});
