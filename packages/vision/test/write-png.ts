import { crc32, deflateSync } from 'node:zlib';
import type { Picture } from '../src/picture.ts';

/** A chunk of a PNG file: length, type, data, checksum. */
export function chunk(type: string, data: Uint8Array): Buffer {
  const body = Buffer.concat([Buffer.from(type, 'latin1'), data]);
  const head = Buffer.alloc(4);
  head.writeUInt32BE(data.length);
  const checksum = Buffer.alloc(4);
  checksum.writeUInt32BE(crc32(body));
  return Buffer.concat([head, body, checksum]);
}

/** Writes a PNG file; rows begin with their filter. */
export function png(
  size: { width: number; height: number; bitDepth: number; colorType: number; interlace?: number },
  rows: readonly (readonly number[])[],
  more: readonly Buffer[] = [],
): Uint8Array {
  const header = Buffer.alloc(13);
  header.writeUInt32BE(size.width, 0);
  header.writeUInt32BE(size.height, 4);
  header.set([size.bitDepth, size.colorType, 0, 0, size.interlace ?? 0], 8);
  return Buffer.concat([
    Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]),
    chunk('IHDR', header),
    ...more,
    chunk('IDAT', deflateSync(Uint8Array.from(rows.flat()))),
    chunk('IEND', Buffer.alloc(0)),
  ]);
}

/** A picture of RGB8 as a PNG file. */
export function pngOf({ width, height, data }: Picture): Uint8Array {
  const rows = Array.from({ length: height }, (_, row) => [
    0,
    ...data.subarray(row * width * 3, (row + 1) * width * 3),
  ]);
  return png({ width, height, bitDepth: 8, colorType: 2 }, rows);
}
