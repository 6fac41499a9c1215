import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { deflateSync } from 'node:zlib';

import { readPictureFile } from '@ubii/pictures';
import { jpegWithDecoy, webpFile, webpLossless, webpLossy } from '@ubii/pictures/testing';

import { decodePicture } from '../../../../packages/vision/src/decoding/decode-picture.ts';
import type { Entrance } from '../entrance.ts';
import { joined } from '../mutate-bytes.ts';
import { mutatePicture, pngChunk } from '../mutate-picture.ts';

const GATE_CASES = 60;

const SEEDS_FILE = join(import.meta.dirname, '../../../seeds/pictures.json');
/** Above it, nothing may be decoded: 4096 × 4096. */
const MAX_PIXELS = 4096 * 4096;

const PNG_SIGNATURE = Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a);
const SIDE = 8;

/** Pictures in records, as modules and pages of this repository read them where there is no browser. */
export const pictures: Entrance = {
  name: 'pictures',
  about: 'heads and decoding of JPEG, PNG and WebP files, in this process',
  kind: 'parser',
  gateCases: GATE_CASES,
  seeds() {
    const { jpeg } = JSON.parse(readFileSync(SEEDS_FILE, 'utf8')) as { readonly jpeg: string };
    const file = new Uint8Array(Buffer.from(jpeg, 'base64'));
    return [
      ...[file, withFillByte(file), withSize(file, 20_000), jpegWithDecoy('fill')],
      ...[pngOf(2), pngOf(6), pngOf(3)],
      ...[webpFile(webpLossy(40, 30)), webpFile(webpLossless(40, 30))],
    ];
  },
  mutate: mutatePicture,
  async deliver(input) {
    const head = allowing(() => readPictureFile(input));
    // Pixels are decoded of what the strict reader takes, and as many as it says.
    const picture = await decodePicture(input).catch(onlyRangeErrors);
    if (picture === undefined) return;
    const { width, height } = picture;
    if (head === undefined) throw new Error('A picture was decoded that the reader refuses.');
    if (width * height !== head.width * head.height || width * height > MAX_PIXELS) {
      throw new Error(`A head of ${head.width} × ${head.height} became ${width} × ${height}.`);
    }
  },
};

/** The frame of a baseline file, which has its size. ITU-T T.81, B.2.2. */
function frameAt(file: Uint8Array): number {
  return Buffer.from(file).indexOf(Uint8Array.of(0xff, 0xc0));
}

function withSize(file: Uint8Array, side: number): Uint8Array {
  const copy = new Uint8Array(file);
  const view = new DataView(copy.buffer);
  view.setUint16(frameAt(file) + 5, side);
  view.setUint16(frameAt(file) + 7, side);
  return copy;
}

/** A head of 20,000 × 20,000 pixels behind a fill byte. */
function withFillByte(file: Uint8Array): Uint8Array {
  const large = withSize(file, 20_000);
  const at = frameAt(large);
  return joined(large.subarray(0, at), Uint8Array.of(0xff), large.subarray(at));
}

/** @param colorType 2: RGB, 3: palette, 6: RGB with opacity. RFC 2083, 4.1.1 */
function pngOf(colorType: 2 | 3 | 6): Uint8Array {
  const channels = { 2: 3, 3: 1, 6: 4 }[colorType];
  const header = new Uint8Array(13);
  const view = new DataView(header.buffer);
  view.setUint32(0, SIDE);
  view.setUint32(4, SIDE);
  header.set([8, colorType], 8);
  const row = 1 + SIDE * channels;
  // The first byte of a row is its filter.
  const rows = Uint8Array.from({ length: row * SIDE }, (_, at) => (at % row ? at % 3 : at % 5));
  const palette = colorType === 3 ? [pngChunk('PLTE', new Uint8Array(9))] : [];
  return joined(
    PNG_SIGNATURE,
    pngChunk('IHDR', header),
    ...palette,
    pngChunk('IDAT', deflateSync(rows)),
    pngChunk('IEND', new Uint8Array()),
  );
}

function allowing<T>(read: () => T): T | undefined {
  try {
    return read();
  } catch (error) {
    return onlyRangeErrors(error);
  }
}

/** @throws what is no documented error */
function onlyRangeErrors(error: unknown): undefined {
  if (!(error instanceof RangeError)) throw error;
}
