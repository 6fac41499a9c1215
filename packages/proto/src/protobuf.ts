/** What the generated functions need beside the Reader and Writer of protobufjs. Not exported from the package. */
import protobuf from 'protobufjs/minimal.js';

export type Reader = protobuf.Reader;
export type Writer = protobuf.Writer;

/** Deepest nesting of groups in unknown fields, the limit of other protobuf implementations. */
export const MAX_GROUP_DEPTH = 100;

/**
 * A reader over bytes. Always the plain one: the reader protobufjs makes for a Node `Buffer` hands
 * out Buffers, which survive neither structured clone nor comparison as what they are.
 */
export function createReader(bytes: Uint8Array): Reader {
  return new protobuf.Reader(
    bytes.constructor === Uint8Array
      ? bytes
      : new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength),
  );
}

export function createWriter(): Writer {
  return new protobuf.Writer();
}

/**
 * Enters a length-delimited member: reads its length and narrows the reader to it.
 *
 * @returns the end of the outer message, to be put back into `reader.len` after the member
 */
export function open(reader: Reader): number {
  const outer = reader.len;
  const length = reader.size();
  const end = reader.pos + length;
  if (end > outer) {
    throw new RangeError(`a member of ${length} bytes at ${reader.pos} ends after byte ${outer}`);
  }
  reader.len = end;
  return outer;
}

/** The member of a oneof that is set. */
export function setMember<K extends string>(
  message: { readonly [P in K]?: unknown },
  keys: readonly K[],
): string | undefined {
  return keys.find((key) => message[key] !== undefined);
}

/** Unsets the member of a oneof that was set before, when it is another one; returns the new one. */
export function only(message: object, before: string | undefined, now: string): string {
  if (before !== undefined && before !== now) {
    delete (message as Record<string, unknown>)[before];
  }
  return now;
}

/** Skips an unknown field, or a known one that came with another wire type. */
export function skip(reader: Reader, tag: number, depth = 0): void {
  if (tag >>> 3 === 0) throw new RangeError('field number 0');
  switch (tag & 7) {
    case 0:
      return skipVarint(reader);
    case 1:
      reader.skip(8);
      return;
    case 2:
      reader.skip(reader.size());
      return;
    case 3:
      return skipGroup(reader, tag, depth + 1);
    case 5:
      reader.skip(4);
      return;
    default:
      throw new RangeError(`wire type ${tag & 7} of field ${tag >>> 3}`);
  }
}

function skipVarint(reader: Reader): void {
  for (let i = 0; i < 10; i++) {
    if (reader.pos >= reader.len) throw new RangeError(`a number ends after byte ${reader.len}`);
    if (reader.buf[reader.pos++]! < 0x80) return;
  }
  throw new RangeError('a number of more than 10 bytes');
}

function skipGroup(reader: Reader, startTag: number, depth: number): void {
  if (depth > MAX_GROUP_DEPTH) throw new RangeError(`groups nest deeper than ${MAX_GROUP_DEPTH}`);
  for (;;) {
    const tag = reader.tag();
    if ((tag & 7) === 4) {
      if (tag >>> 3 !== startTag >>> 3) {
        throw new RangeError(`group ${startTag >>> 3} ends as group ${tag >>> 3}`);
      }
      return;
    }
    skip(reader, tag, depth);
  }
}

/** A view of the input, not a copy: see `decode`. */
export function readBytes(reader: Reader): Uint8Array {
  return reader.bytes();
}

/** Signed 64-bit varint as a number; exact up to 2^53. */
export function readInt64(reader: Reader): number {
  let low = 0; // bits 0 to 27
  let middle = 0; // bits 28 to 55
  let high = 0; // bits 56 to 63
  for (let i = 0; i < 10; i++) {
    if (reader.pos >= reader.len) throw new RangeError(`a number ends after byte ${reader.len}`);
    const byte = reader.buf[reader.pos++]!;
    const bits = byte & 0x7f;
    if (i < 4) low |= bits << (7 * i);
    else if (i < 8) middle |= bits << (7 * (i - 4));
    else high |= bits << (7 * (i - 8));
    if (byte < 0x80) {
      high &= 0xff;
      return (high < 0x80 ? high : high - 0x100) * 2 ** 56 + middle * 2 ** 28 + low;
    }
  }
  throw new RangeError('a number of more than 10 bytes');
}

const SURROGATE = /[\ud800-\udfff]/;
const LONE_SURROGATE = /[\ud800-\udbff](?![\udc00-\udfff])|(?<![\ud800-\udbff])[\udc00-\udfff]/g;

/**
 * Writes text. Half a surrogate pair, which UTF-8 cannot express, becomes U+FFFD.
 *
 * @throws TypeError when it is not text: the writer would write nothing in its place
 */
export function writeString(writer: Writer, text: string): void {
  if (typeof text !== 'string') throw new TypeError(`expected text, got ${typeof text}`);
  writer.string(SURROGATE.test(text) ? text.replace(LONE_SURROGATE, '\ufffd') : text);
}

/** True for arrays of bytes, those of a canvas included, of whatever realm. */
export function isBytes(value: unknown): value is Uint8Array {
  return ArrayBuffer.isView(value) && (value as Uint8Array).BYTES_PER_ELEMENT === 1;
}

/**
 * Writes bytes.
 *
 * @throws TypeError when they are not bytes: the writer would write nothing in their place
 */
export function writeBytes(writer: Writer, bytes: Uint8Array | Uint8ClampedArray): void {
  if (!isBytes(bytes)) throw new TypeError(`expected a Uint8Array, got ${typeof bytes}`);
  writer.bytes(bytes);
}
