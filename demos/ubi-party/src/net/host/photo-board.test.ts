import { jpegFile, jpegFrame, jpegWithDecoy } from '@ubii/pictures/testing';
import { expect, it } from 'vitest';

import { photoFile } from './photo-board.ts';

it('reads a JPEG file of a size that phones send', () => {
  const data = jpegFile(480, 270);
  expect(photoFile(data)).toMatchObject({ width: 480, height: 270, data });
});

const large = jpegFrame(20_000, 20_000);
it.each([
  ['more pixels on one side', jpegFile(481, 270)],
  ['as many pixels as a file can state', jpegFile(65_535, 65_535, { scanBytes: 9 })],
  ['a fill byte that hides its frame', jpegWithDecoy('fill')],
  ['a marker without a length that hides its frame', jpegWithDecoy('marker')],
  ['a second frame', jpegFile(9, 9, { after: large })],
  ['no pixels', jpegFile(0, 10)],
  ['more bytes', jpegFile(480, 270, { scanBytes: 60_001 })],
  ['a frame that is cut off', jpegFile(480, 270).slice(0, 120)],
  ['a PNG', Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0, 0, 0, 13)],
  ['a segment without a length', Uint8Array.of(0xff, 0xd8, 0xff, 0xe0, 0, 0, 0, 0, 0, 0, 0, 0, 0)],
  ['nothing', new Uint8Array()],
])('refuses a file with %s [EX-98]', (_what, data) => {
  expect(photoFile(data)).toBeUndefined();
});
