import { describe, expect, it } from 'vitest';
import { readPictureFile } from './picture-file.ts';
import { MAX_CHOSEN_PIXELS, MAX_PIXELS } from './picture-head.ts';
import {
  jpegFile,
  jpegFrame,
  jpegSegment,
  jpegWithDecoy,
  pngChunk,
  pngFile,
  pngHeader,
  webpCanvas,
  webpChunk,
  webpFile,
  webpLossless,
  webpLossy,
} from './testing/picture-files.ts';

const DAMAGED = /is damaged. Send the complete file\.$/;
const STILL = /is animated, which is not supported\. Send a still picture\.$/;
const LARGE = 'A picture of 20000 × 20000 pixels is too large.';
const IDAT = pngChunk('IDAT', [1, 2, 3]);
const IEND = pngChunk('IEND');

it.each([
  ['baseline JPEG', jpegFile(40, 30)],
  ['progressive JPEG', jpegFile(40, 30, { frame: jpegFrame(40, 30, 0xc2), scans: 10 })],
  ['JPEG with fill bytes', jpegFile(40, 30, { before: [0xff, 0xff, ...jpegSegment(0xfe, [1])] })],
  [
    'JPEG with a picture within Exif',
    jpegFile(40, 30, { before: jpegSegment(0xe1, [...jpegFile(9, 9)]) }),
  ],
  ['PNG', pngFile(pngHeader(40, 30), pngChunk('tEXt', [1]), IDAT, IDAT, IEND)],
  ['lossy WebP', webpFile(webpLossy(40, 30))],
  ['lossless WebP', webpFile(webpLossless(40, 30))],
  ['WebP with a canvas', webpFile(webpCanvas(40, 30), webpChunk('ALPH', [1]), webpLossy(40, 30))],
])('reads the size of a %s [EX-98]', (_what, data) => {
  expect(readPictureFile(data)).toMatchObject({ width: 40, height: 30, orientation: 1, data });
});

it.each([
  ['JPEG', jpegFile(40, 30)],
  ['PNG', pngFile(pngHeader(40, 30), IDAT, IEND)],
  ['WebP', webpFile(webpLossy(40, 30))],
])('hands on nothing that follows a picture of %s [EX-98]', (format, file) => {
  const followed = Uint8Array.from([...file, ...jpegFile(20_000, 20_000, { scanBytes: 9 })]);
  expect(readPictureFile(followed)).toMatchObject({ format, data: file });
});

describe('refuses a small file of many pixels [EX-98]', () => {
  const frame = jpegFrame(20_000, 20_000);
  const marked = (...before: number[]): Uint8Array =>
    jpegFile(20_000, 20_000, { before, scanBytes: 9 });
  it.each([
    ['JPEG', marked()],
    ['JPEG with a fill byte before the frame', jpegFile(1, 1, { frame: [0xff, ...frame] })],
    ['JPEG with fill bytes', marked(0xff, 0xff, ...jpegSegment(0xe0))],
    ['JPEG with a fill byte and a decoy', jpegWithDecoy('fill')],
    ['progressive JPEG', jpegFile(1, 1, { frame: jpegFrame(20_000, 20_000, 0xc2) })],
    ['PNG', pngFile(pngHeader(20_000, 20_000), IDAT, IEND)],
    ['WebP with a canvas', webpFile(webpCanvas(20_000, 20_000), webpLossy(20_000 & 0x3fff, 9))],
  ])('%s', (what, file) => {
    expect(file.length).toBeLessThan(60_000);
    expect(() => readPictureFile(file)).toThrow(what.startsWith('WebP') ? DAMAGED : LARGE);
  });

  it('states the limit of the caller', () => {
    expect(() => readPictureFile(jpegFile(5000, 5000, { scanBytes: 9 }))).toThrow(
      `At most ${MAX_PIXELS / 2 ** 20} megapixels`,
    );
    const { width } = readPictureFile(jpegFile(5000, 5000, { scanBytes: 9 }), MAX_CHOSEN_PIXELS);
    expect(width).toBe(5000);
  });
});

it.each([
  ['TEM and a decoy', jpegWithDecoy('marker'), DAMAGED],
  ['TEM before the frame', jpegFile(9, 9, { before: [0xff, 0x01] }), DAMAGED],
  ['RST0 before the frame', jpegFile(9, 9, { before: [0xff, 0xd0] }), DAMAGED],
  ['RST7 between frame and scan', jpegFile(9, 9, { after: [0xff, 0xd7] }), DAMAGED],
  ['a second SOI', jpegFile(9, 9, { before: [0xff, 0xd8] }), DAMAGED],
  ['an end before the frame', jpegFile(9, 9, { before: [0xff, 0xd9] }), DAMAGED],
  ['a reserved marker', jpegFile(9, 9, { before: jpegSegment(0x02) }), DAMAGED],
  ['bytes between segments', jpegFile(9, 9, { after: [0] }), DAMAGED],
  ['a segment of no length', jpegFile(9, 9, { before: [0xff, 0xe0, 0, 0] }), DAMAGED],
  ['a segment beyond the end', jpegFile(9, 9, { before: [0xff, 0xe0, 0xff, 0xff] }), DAMAGED],
  ['a second frame', jpegFile(9, 9, { after: jpegFrame(20_000, 20_000) }), /has several frames/],
  ['a frame after the first scan', frameAfterScan(), /has several frames/],
  ['no height', jpegFile(9, 0), /cannot have 9 × 0 pixels/],
  ['no height, and DNL', jpegFile(9, 0, { after: jpegSegment(0xdc, [9, 9]) }), /states its height/],
  ['an arithmetic frame', jpegFile(9, 9, { frame: jpegFrame(9, 9, 0xc9) }), /neither baseline nor/],
  ['a lossless frame', jpegFile(9, 9, { frame: jpegFrame(9, 9, 0xc3) }), /neither baseline nor/],
  [
    'a frame without components',
    jpegFile(9, 9, { frame: jpegSegment(0xc0, [8, 0, 9, 0, 9, 0]) }),
    DAMAGED,
  ],
  ['a frame that is cut off', jpegFile(9, 9).subarray(0, -14 - 30), DAMAGED],
  ['no frame', jpegFile(9, 9, { frame: [] }), DAMAGED],
  ['101 scans', jpegFile(9, 9, { scans: 101 }), /has more than 100 scans/],
])('refuses a JPEG with %s [EX-98]', (_what, file, message) => {
  expect(() => readPictureFile(file)).toThrow(message);
});

it.each([
  ['a chunk before IHDR', pngFile(pngChunk('CgBI', [0]), pngHeader(9, 9), IDAT, IEND), DAMAGED],
  ['a second IHDR', pngFile(pngHeader(9, 9), pngHeader(20_000, 9), IDAT, IEND), DAMAGED],
  ['no pixels', pngFile(pngHeader(9, 9), IEND), DAMAGED],
  ['no end', pngFile(pngHeader(9, 9), IDAT), DAMAGED],
  ['a size of 0', pngFile(pngHeader(0, 9), IDAT, IEND), /cannot have 0 × 9 pixels/],
  ['a size of 2^32 - 1', pngFile(pngHeader(2 ** 32 - 1, 1), IDAT, IEND), /is too large/],
  ['frames', pngFile(pngHeader(9, 9), pngChunk('acTL'), IDAT, IEND), STILL],
])('refuses a PNG with %s [EX-98]', (_what, file, message) => {
  expect(() => readPictureFile(file)).toThrow(message);
});

it.each([
  ['a canvas larger than its picture', webpFile(webpCanvas(9, 10), webpLossy(9, 9)), DAMAGED],
  ['a canvas and no picture', webpFile(webpCanvas(9, 9)), DAMAGED],
  ['a canvas after its picture', webpFile(webpLossy(9, 9), webpCanvas(9, 9)), DAMAGED],
  ['two pictures', webpFile(webpLossy(9, 9), webpLossless(99, 9)), /has several pictures/],
  ['an announced animation', webpFile(webpCanvas(9, 9, 2), webpLossy(9, 9)), STILL],
  ['a frame of an animation', webpFile(webpLossy(9, 9), webpChunk('ANMF')), STILL],
  ['another first chunk', webpFile(webpChunk('ALPH'), webpLossy(9, 9)), DAMAGED],
  ['a width of 0', webpFile(webpLossy(0, 9)), /cannot have 0 × 9 pixels/],
  ['a version that is unknown', webpFile(webpChunk('VP8L', [0x2f, 8, 0, 2, 0xe0])), DAMAGED],
  ['a cut end', webpFile(webpLossy(9, 9)).subarray(0, -1), DAMAGED],
  ['a header alone', webpFile(), DAMAGED],
])('refuses a WebP with %s [EX-98]', (_what, file, message) => {
  expect(() => readPictureFile(file)).toThrow(message);
});

it.each([
  ['GIF', 'GIF89a'],
  ['BMP', 'BM'],
  ['AVIF', '\0\0\0\x1cftypavif'],
  ['HEIC', '\0\0\0\x1cftypheic'],
  ['SVG', '<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"/>'],
  ['sound in RIFF', 'RIFF\0\0\0\0WAVE'],
  ['nothing', ''],
])('refuses %s [EX-98]', (_what, start) => {
  const file = Uint8Array.from(Array.from(start, (letter) => letter.charCodeAt(0)));
  expect(() => readPictureFile(file)).toThrow('The file is not a picture. Send JPEG, PNG or WebP.');
});

it('refuses or reads every beginning of a file without another error', () => {
  for (const file of [
    jpegFile(40, 30),
    pngFile(pngHeader(40, 30), IDAT, IEND),
    webpFile(webpCanvas(40, 30), webpLossy(40, 30)),
  ]) {
    for (let length = 0; length < file.length; length++) {
      try {
        expect(readPictureFile(file.subarray(0, length))).toMatchObject({ width: 40, height: 30 });
      } catch (error) {
        expect(error).toBeInstanceOf(RangeError);
        expect((error as Error).message).toMatch(/Send/);
      }
    }
  }
});

function frameAfterScan(): Uint8Array {
  const file = jpegFile(9, 9);
  return Uint8Array.from([...file.subarray(0, -2), ...jpegFrame(20_000, 20_000), 0xff, 0xd9]);
}
