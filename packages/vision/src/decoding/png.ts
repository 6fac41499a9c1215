import type { PictureFile } from '@ubii/pictures';
import type { OwnPicture } from '../picture.ts';

/** Length of the signature, and of a chunk without its data. RFC 2083, 3. */
const SIGNATURE_BYTES = 8;
const CHUNK_BYTES = 12;

/** Channels of a pixel by colour type. RFC 2083, 4.1.1. */
const COLOR_TYPES: Readonly<Record<number, number>> = { 0: 1, 2: 3, 3: 1, 4: 2, 6: 4 };
const PALETTE_TYPE = 3;

interface Header {
  readonly width: number;
  readonly height: number;
  readonly bitDepth: number;
  readonly colorType: number;
}

/**
 * Decodes a PNG file to RGBA8, or to GRAY8 when it is grey without opacity. 16-bit channels are reduced to
 * 8 bits; colour spaces are ignored.
 *
 * Source: RFC 2083.
 *
 * @throws RangeError for damaged and interlaced files
 */
export async function decodePng({ data: file }: PictureFile): Promise<OwnPicture> {
  const chunks = readChunks(file);
  const header = readHeader(chunks[0]);
  const { width, height, bitDepth, colorType } = header;
  const channels = COLOR_TYPES[colorType]!;
  const rowBytes = Math.ceil((width * channels * bitDepth) / 8);
  const pixelBytes = Math.max(1, (channels * bitDepth) / 8);
  const compressed = chunks.filter(({ type }) => type === 'IDAT').map(({ data }) => data);
  const rows = await inflate(compressed, (rowBytes + 1) * height);
  removeFilters(rows, rowBytes, pixelBytes);
  const samples = readSamples(rows, rowBytes, width * channels, bitDepth, height);
  const dataOf = (type: string): Uint8Array | undefined =>
    chunks.find((chunk) => chunk.type === type)?.data;
  return toPicture(samples, header, dataOf('PLTE'), dataOf('tRNS'));
}

function readChunks(file: Uint8Array): { type: string; data: Uint8Array }[] {
  const view = new DataView(file.buffer, file.byteOffset, file.byteLength);
  const chunks: { type: string; data: Uint8Array }[] = [];
  let at = SIGNATURE_BYTES;
  while (at + CHUNK_BYTES <= file.length) {
    const length = view.getUint32(at);
    if (length > file.length - at - CHUNK_BYTES) break;
    const type = String.fromCharCode(...file.subarray(at + 4, at + 8));
    if (type === 'IEND') return chunks;
    chunks.push({ type, data: file.subarray(at + 8, at + 8 + length) });
    at += CHUNK_BYTES + length;
  }
  throw damaged();
}

function readHeader(chunk: { type: string; data: Uint8Array } | undefined): Header {
  if (chunk?.type !== 'IHDR' || chunk.data.length !== 13) throw damaged();
  const view = new DataView(chunk.data.buffer, chunk.data.byteOffset, chunk.data.byteLength);
  const [width, height] = [view.getUint32(0), view.getUint32(4)];
  const [bitDepth, colorType, , , interlace] = chunk.data.subarray(8);
  if (interlace !== 0) {
    throw new RangeError('The PNG file is interlaced, which is not supported. Save it without.');
  }
  return { width, height, bitDepth: bitDepth!, colorType: colorType! };
}

/** @param length expected; a file that contains more is not read to its end */
async function inflate(parts: readonly Uint8Array[], length: number): Promise<Uint8Array> {
  const result = new Uint8Array(length);
  let at = 0;
  try {
    const blob = new Blob(parts.map((part) => part.slice()));
    const reader = blob.stream().pipeThrough(new DecompressionStream('deflate')).getReader();
    for (;;) {
      const { done, value } = await reader.read();
      if (done) break;
      const rest = value.subarray(0, length - at);
      result.set(rest, at);
      at += rest.length;
      if (at === length) {
        await reader.cancel();
        break;
      }
    }
  } catch {
    throw damaged();
  }
  if (at !== length) throw damaged();
  return result;
}

/** Undoes the filter that each row begins with, in place. RFC 2083, 6. */
function removeFilters(rows: Uint8Array, rowBytes: number, pixelBytes: number): void {
  for (let start = 0; start < rows.length; start += rowBytes + 1) {
    const filter = rows[start]!;
    if (filter > 4) throw damaged();
    const above = start - rowBytes - 1;
    for (let index = 1; index <= rowBytes && filter !== 0; index++) {
      const left = index > pixelBytes ? rows[start + index - pixelBytes]! : 0;
      const up = above >= 0 ? rows[above + index]! : 0;
      const corner = above >= 0 && index > pixelBytes ? rows[above + index - pixelBytes]! : 0;
      rows[start + index]! += predict(filter, left, up, corner);
    }
  }
}

function predict(filter: number, left: number, up: number, corner: number): number {
  if (filter === 1) return left;
  if (filter === 2) return up;
  if (filter === 3) return (left + up) >> 1;
  const estimate = left + up - corner;
  const [a, b, c] = [estimate - left, estimate - up, estimate - corner].map(Math.abs);
  return a! <= b! && a! <= c! ? left : b! <= c! ? up : corner;
}

/** Returns one byte for each channel of each pixel; not scaled when it has less than 8 bits. */
function readSamples(
  rows: Uint8Array,
  rowBytes: number,
  perRow: number,
  bitDepth: number,
  height: number,
): Uint8Array {
  const samples = new Uint8Array(perRow * height);
  for (let row = 0; row < height; row++) {
    const from = row * (rowBytes + 1) + 1;
    for (let index = 0; index < perRow; index++) {
      const bit = index * bitDepth;
      const byte = rows[from + (bit >> 3)]!;
      // Of 16 bits, the first byte is the high one.
      samples[row * perRow + index] =
        bitDepth >= 8 ? byte : (byte >> (8 - bitDepth - (bit & 7))) & (2 ** bitDepth - 1);
    }
  }
  return samples;
}

function toPicture(
  samples: Uint8Array,
  { width, height, bitDepth, colorType }: Header,
  palette: Uint8Array | undefined,
  transparency: Uint8Array | undefined,
): OwnPicture {
  const channels = COLOR_TYPES[colorType]!;
  const scale = bitDepth < 8 && colorType !== PALETTE_TYPE ? 255 / (2 ** bitDepth - 1) : 1;
  if (colorType === 0) {
    return { width, height, format: 'GRAY8', data: samples.map((sample) => sample * scale) };
  }
  if (colorType === PALETTE_TYPE && palette === undefined) throw damaged();
  const data = new Uint8Array(width * height * 4).fill(255);
  for (let pixel = 0; pixel < width * height; pixel++) {
    const from = pixel * channels;
    const to = pixel * 4;
    if (colorType === PALETTE_TYPE) {
      const color = samples[from]!;
      data.set(palette!.subarray(color * 3, color * 3 + 3), to);
      data[to + 3] = transparency?.[color] ?? 255;
    } else if (channels === 2) {
      data.fill(samples[from]!, to, to + 3);
      data[to + 3] = samples[from + 1]!;
    } else {
      for (let channel = 0; channel < channels; channel++) {
        data[to + channel] = samples[from + channel]!;
      }
    }
  }
  return { width, height, format: 'RGBA8', data };
}

function damaged(): RangeError {
  return new RangeError('The PNG file is damaged. Send the complete file.');
}
