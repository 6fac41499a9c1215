import type { Random } from '../random.ts';
import { joined, mutateBytes } from './mutate-bytes.ts';

/** A field of the protobuf wire format. Source: protobuf.dev/programming-guides/encoding. */
interface Field {
  readonly number: number;
  readonly wireType: number;
  /** Content without tag and length. */
  readonly content: Uint8Array;
}

const LENGTH_DELIMITED = 2;
const MAX_DEPTH = 12;
const MAX_CHANGES = 3;

/** Changes an encoded message by its structure: fields, tags, lengths, at any depth. */
export function mutateWire(random: Random, seed: Uint8Array, other: Uint8Array): Uint8Array {
  let bytes = seed;
  const changes = 1 + random.below(MAX_CHANGES);
  for (let i = 0; i < changes; i++) bytes = changeMessage(random, bytes, other, 0);
  return bytes;
}

function changeMessage(
  random: Random,
  bytes: Uint8Array,
  other: Uint8Array,
  depth: number,
): Uint8Array {
  const fields = readFields(bytes);
  if (fields === undefined || fields.length === 0) return mutateBytes(random, bytes, other);
  const index = random.below(fields.length);
  const field = fields[index]!;
  const before = fields.slice(0, index).map(written);
  const after = fields.slice(index + 1).map(written);
  const put = (...parts: readonly Uint8Array[]): Uint8Array =>
    joined(...before, ...parts, ...after);
  const isMessage = field.wireType === LENGTH_DELIMITED && depth < MAX_DEPTH;
  if (isMessage && !random.oneIn(3)) {
    return put(
      written({ ...field, content: changeMessage(random, field.content, other, depth + 1) }),
    );
  }
  switch (random.below(9)) {
    case 0:
      return put();
    case 1:
      return put(...Array.from({ length: random.oneIn(10) ? 3_000 : 2 }, () => written(field)));
    case 2:
      return put(
        written({ ...field, number: random.pick([0, 1, 2, 15, 16, 999, 1000, 536_870_911]) }),
      );
    case 3:
      return put(tag(field.number, random.below(8)), varint(field.content.length), field.content);
    case 4:
      return put(tag(field.number, LENGTH_DELIMITED), strangeLength(random), field.content);
    case 5:
      return joined(...after, written(field), ...before);
    case 6:
      return put(written({ ...field, content: mutateBytes(random, field.content, other) }));
    case 7:
      return put(nestedIn(field, 10 + random.below(random.oneIn(6) ? 3_000 : 90)));
    default:
      return put(written({ ...field, content: other }));
  }
}

function readFields(bytes: Uint8Array): Field[] | undefined {
  const fields: Field[] = [];
  let at = 0;
  while (at < bytes.length) {
    const head = readVarint(bytes, at);
    if (head === undefined || head.value < 8) return undefined;
    at = head.end;
    const number = Math.floor(head.value / 8);
    const wireType = head.value % 8;
    let end: number;
    let start = at;
    if (wireType === 0) {
      const value = readVarint(bytes, at);
      if (value === undefined) return undefined;
      end = value.end;
    } else if (wireType === 1 || wireType === 5) {
      end = at + (wireType === 1 ? 8 : 4);
    } else if (wireType === LENGTH_DELIMITED) {
      const length = readVarint(bytes, at);
      if (length === undefined) return undefined;
      start = length.end;
      end = start + length.value;
    } else return undefined;
    if (end > bytes.length) return undefined;
    fields.push({ number, wireType, content: bytes.subarray(start, end) });
    at = end;
  }
  return fields;
}

function readVarint(bytes: Uint8Array, start: number): { value: number; end: number } | undefined {
  let value = 0;
  for (let i = 0; i < 8; i++) {
    const byte = bytes[start + i];
    if (byte === undefined) return undefined;
    value += (byte & 0x7f) * 2 ** (7 * i);
    if (byte < 0x80) return { value, end: start + i + 1 };
  }
  return undefined;
}

function written({ number, wireType, content }: Field): Uint8Array {
  const length = wireType === LENGTH_DELIMITED ? varint(content.length) : new Uint8Array();
  return joined(tag(number, wireType), length, content);
}

function tag(number: number, wireType: number): Uint8Array {
  return varint(number * 8 + wireType);
}

function varint(value: number): Uint8Array {
  const bytes: number[] = [];
  let rest = value;
  do {
    const byte = rest % 128;
    rest = Math.floor(rest / 128);
    bytes.push(rest > 0 ? byte | 0x80 : byte);
  } while (rest > 0);
  return Uint8Array.from(bytes);
}

/** Lengths that lie: too long, beyond 2^31, without an end, longer than they need to be. */
function strangeLength(random: Random): Uint8Array {
  return random.pick([
    varint(2 ** 31 - 1),
    varint(2 ** 32 + 1),
    varint(2 ** 53),
    new Uint8Array(10).fill(0xff),
    Uint8Array.of(0x81, 0x80, 0x80, 0x00),
    Uint8Array.of(0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0x01),
    varint(random.below(300)),
  ]);
}

/** The field in itself, again and again. */
function nestedIn(field: Field, depth: number): Uint8Array {
  let content = field.content;
  for (let i = 0; i < depth; i++) {
    content = written({ number: field.number, wireType: LENGTH_DELIMITED, content });
  }
  return content;
}
