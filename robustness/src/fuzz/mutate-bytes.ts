import type { Random } from '../random.ts';

/** Bytes that formats give a meaning: ends of ranges, separators, quotes, tags of wire types. */
const INTERESTING = [
  0x00, 0x01, 0x07, 0x08, 0x0a, 0x0d, 0x12, 0x1a, 0x20, 0x22, 0x25, 0x2d, 0x2e, 0x2f, 0x30, 0x39,
  0x3a, 0x3d, 0x5b, 0x5c, 0x7b, 0x7d, 0x7e, 0x7f, 0x80, 0x81, 0x8a, 0xc0, 0xed, 0xf0, 0xfe, 0xff,
];
const MAX_BYTES = 256 * 1024;
const MAX_CHANGES = 4;

/** Changes bytes without knowing what they mean. @param other another seed, to splice with */
export function mutateBytes(random: Random, seed: Uint8Array, other: Uint8Array): Uint8Array {
  let bytes = seed;
  const changes = 1 + random.below(MAX_CHANGES);
  for (let i = 0; i < changes; i++) bytes = change(random, bytes, other);
  return bytes.subarray(0, MAX_BYTES);
}

function change(random: Random, bytes: Uint8Array, other: Uint8Array): Uint8Array {
  const at = random.below(bytes.length + 1);
  const length = 1 + random.below(Math.min(32, bytes.length - at));
  switch (random.below(9)) {
    case 0:
      return replaced(bytes, at, (byte) => byte ^ (1 << random.below(8)));
    case 1:
      return replaced(bytes, at, () => random.pick(INTERESTING));
    case 2:
      return replaced(bytes, at, (byte) => byte + random.pick([1, -1]));
    case 3:
      return joined(bytes.subarray(0, at), bytes.subarray(at + length));
    case 4:
      return joined(bytes.subarray(0, at), random.bytes(length), bytes.subarray(at));
    case 5:
      return bytes.subarray(0, at);
    case 6: {
      const part = bytes.subarray(at, at + length);
      const copies = Array.from(
        { length: 1 + random.below(random.oneIn(8) ? 2_000 : 8) },
        () => part,
      );
      return joined(bytes.subarray(0, at), ...copies, bytes.subarray(at));
    }
    case 7:
      return joined(bytes.subarray(0, at), other.subarray(random.below(other.length)));
    default:
      return replaced(bytes, at, () => random.next() & 0xff);
  }
}

function replaced(bytes: Uint8Array, at: number, of: (byte: number) => number): Uint8Array {
  // `slice` of a Buffer would not copy.
  const copy = new Uint8Array(bytes);
  if (at < copy.length) copy[at] = of(copy[at]!);
  return copy;
}

export function joined(...parts: readonly Uint8Array[]): Uint8Array {
  return Buffer.concat(parts);
}
