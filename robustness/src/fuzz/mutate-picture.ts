import { crc32 } from 'node:zlib';
import type { Random } from '../random.ts';
import { joined, mutateBytes } from './mutate-bytes.ts';

/** Sides of pictures: small ones, and those that no decoder may allocate. */
const SIDES = [0, 1, 7, 16, 64, 20_000, 65_535];
const PNG_SIGNATURE_BYTES = 8;
/** Markers of JPEG: without a length (TEM, RST0, SOI), frames, tables, DNL, application data. ITU-T T.81, table B.1. */
const MARKERS = [
  0x00, 0x01, 0xc0, 0xc2, 0xc4, 0xc9, 0xd0, 0xd8, 0xd9, 0xda, 0xdb, 0xdc, 0xe1, 0xff,
];

/** Changes segments of a JPEG file, or chunks of a PNG file with checksums that fit. */
export function mutatePicture(random: Random, seed: Uint8Array, other: Uint8Array): Uint8Array {
  const isJpeg = seed[0] === 0xff && seed[1] === 0xd8;
  if (random.oneIn(4)) return mutateBytes(random, seed, other);
  return isJpeg ? mutateJpeg(random, seed) : mutatePng(random, seed, other);
}

function mutateJpeg(random: Random, seed: Uint8Array): Uint8Array {
  const { segments, rest } = segmentsOf(seed);
  const changes = 1 + random.below(3);
  for (let i = 0; i < changes; i++) {
    const at = random.below(segments.length + 1);
    const segment = segments[at];
    switch (random.below(7)) {
      case 0:
        segments.splice(at, 0, new Uint8Array(1 + random.below(5)).fill(0xff));
        break;
      case 1:
        segments.splice(at, 0, Uint8Array.of(0xff, random.pick(MARKERS)));
        break;
      case 2:
        segments.splice(at, 1);
        break;
      case 3:
        segments.splice(at, 0, frame(random));
        break;
      case 4:
        if (segment !== undefined) segments[at] = withLength(random, segment);
        break;
      case 5:
        if (segment !== undefined) segments.splice(random.below(segments.length), 0, segment);
        break;
      default:
        if (segment !== undefined && segment.length > 4) {
          const body = mutateBytes(random, segment.subarray(4), segment);
          segments[at] = withLength(undefined, joined(segment.subarray(0, 4), body));
        }
    }
  }
  return joined(seed.subarray(0, 2), ...segments, rest);
}

/** Segments up to the first scan, each with its marker and length. */
function segmentsOf(file: Uint8Array): { segments: Uint8Array[]; rest: Uint8Array } {
  const view = new DataView(file.buffer, file.byteOffset, file.byteLength);
  const segments: Uint8Array[] = [];
  let at = 2;
  while (at + 4 <= file.length && file[at] === 0xff && file[at + 1] !== 0xda) {
    const end = at + 2 + view.getUint16(at + 2);
    if (end > file.length || end < at + 4) break;
    segments.push(file.subarray(at, end));
    at = end;
  }
  return { segments, rest: file.subarray(at) };
}

/** A frame header of one component. ITU-T T.81, B.2.2. */
function frame(random: Random): Uint8Array {
  const bytes = Uint8Array.of(0xff, random.pick([0xc0, 0xc2]), 0, 11, 8, 0, 0, 0, 0, 1, 1, 0x11, 0);
  const view = new DataView(bytes.buffer);
  view.setUint16(5, random.pick(SIDES));
  view.setUint16(7, random.pick(SIDES));
  return bytes;
}

/** States the length that a segment has, or another one. */
function withLength(random: Random | undefined, segment: Uint8Array): Uint8Array {
  const copy = new Uint8Array(segment);
  const fits = Math.min(copy.length - 2, 0xffff);
  if (copy.length >= 4) {
    const stated = random === undefined ? fits : random.pick([0, 1, 2, fits - 1, fits + 1, 0xffff]);
    new DataView(copy.buffer).setUint16(2, stated);
  }
  return copy;
}

function mutatePng(random: Random, seed: Uint8Array, other: Uint8Array): Uint8Array {
  const chunks = chunksOf(seed);
  if (chunks.length === 0) return mutateBytes(random, seed, other);
  const at = random.below(chunks.length);
  const { type, data } = chunks[at]!;
  const changed = new Uint8Array(data);
  const put = (...instead: readonly Uint8Array[]): void =>
    void chunks.splice(at, 1, ...instead.map((one) => ({ type, data: one })));
  switch (random.below(5)) {
    case 0:
      put();
      break;
    case 1:
      put(...Array.from({ length: random.oneIn(8) ? 1_000 : 2 }, () => data));
      break;
    case 2:
      if (type === 'IHDR' && changed.length >= 8) {
        const view = new DataView(changed.buffer);
        view.setUint32(random.pick([0, 4]), random.pick([...SIDES, 2 ** 31, 2 ** 32 - 1]));
      }
      put(changed);
      break;
    default:
      put(mutateBytes(random, data, other));
  }
  const signature = seed.subarray(0, PNG_SIGNATURE_BYTES);
  return joined(signature, ...chunks.map((chunk) => pngChunk(chunk.type, chunk.data)));
}

function chunksOf(file: Uint8Array): { readonly type: string; readonly data: Uint8Array }[] {
  const view = new DataView(file.buffer, file.byteOffset, file.byteLength);
  const chunks: { type: string; data: Uint8Array }[] = [];
  for (let at = PNG_SIGNATURE_BYTES; at + 12 <= file.length;) {
    const end = at + 8 + view.getUint32(at);
    if (end + 4 > file.length) break;
    const type = Buffer.from(file.subarray(at + 4, at + 8)).toString('latin1');
    chunks.push({ type, data: file.subarray(at + 8, end) });
    at = end + 4;
  }
  return chunks;
}

/** A chunk with its checksum. RFC 2083, 3.2. */
export function pngChunk(type: string, data: Uint8Array): Uint8Array {
  const body = joined(Buffer.from(type, 'latin1'), data);
  const ends = new Uint8Array(8);
  const view = new DataView(ends.buffer);
  view.setUint32(0, data.length);
  view.setUint32(4, crc32(body));
  return joined(ends.subarray(0, 4), body, ends.subarray(4));
}
