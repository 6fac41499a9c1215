import { expect, it } from 'vitest';
import { isPhoto } from './check-photo.ts';
import { jpegOf } from '../testing/jpeg.ts';

it('takes a JPEG file of a size that phones send', () => {
  expect(isPhoto(jpegOf(480, 270))).toBe(true);
});

it.each([
  ['more pixels on one side', jpegOf(481, 270)],
  ['as many pixels as a file can say', jpegOf(65_535, 65_535)],
  ['no pixels', jpegOf(0, 10)],
  ['more bytes', jpegOf(480, 270, 60_001)],
  ['a frame that is cut off', jpegOf(480, 270).slice(0, 8)],
  ['a PNG', Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0, 0, 0, 13)],
  ['a segment without a length', Uint8Array.of(0xff, 0xd8, 0xff, 0xe0, 0, 0, 0, 0, 0, 0, 0, 0, 0)],
  ['nothing', new Uint8Array()],
])('takes no file with %s', (_what, data) => {
  expect(isPhoto(data)).toBe(false);
});
