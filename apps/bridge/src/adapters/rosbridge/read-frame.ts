import { decode } from 'cborg';
import { parseBoundedJson } from '../../core/payload/parse-bounded-json.ts';

type ArrayType = new (buffer: ArrayBuffer) => ArrayLike<number | bigint>;

/** Typed arrays of RFC 8746 that rosbridge sends, little-endian. */
const TYPED_ARRAYS: Readonly<Record<number, ArrayType>> = {
  69: Uint16Array,
  70: Uint32Array,
  72: Int8Array,
  77: Int16Array,
  78: Int32Array,
  85: Float32Array,
  86: Float64Array,
};

const TAGS = Object.fromEntries([
  [64, (inner: () => unknown) => inner()],
  ...Object.entries(TYPED_ARRAYS).map(([tag, Type]) => [
    tag,
    (inner: () => unknown) => new Type(Uint8Array.from(inner() as Uint8Array).buffer),
  ]),
]) as Record<number, (inner: () => unknown) => unknown>;

/**
 * Reads a frame of rosbridge: JSON in text, CBOR in binary ones.
 *
 * @throws Error with the reason
 */
export function readFrame(bytes: Uint8Array, isBinary: boolean): Readonly<Record<string, unknown>> {
  const read: unknown = isBinary ? decode(bytes, { tags: TAGS }) : parseBoundedJson(bytes);
  if (typeof read === 'object' && read !== null) return read as Readonly<Record<string, unknown>>;
  throw new Error('The message is no object.');
}
