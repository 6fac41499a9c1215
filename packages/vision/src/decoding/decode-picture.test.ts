import { readFileSync } from 'node:fs';
import { jpegFile, jpegFrame, jpegWithDecoy } from '@ubii/pictures/testing';
import { encode } from 'jpeg-js';
import { describe, expect, it } from 'vitest';
import { readPhoto } from '../../test/photos.ts';
import { chunk, png } from '../../test/write-png.ts';
import { decodePicture, readImage2D, orient } from './decode-picture.ts';

const photo = (file: string) =>
  new Uint8Array(readFileSync(new URL(`../../photos/${file}`, import.meta.url)));

describe('decodePicture: PNG', () => {
  it.each([
    ['grey', { bitDepth: 8, colorType: 0 }, [[0, 10, 200]], 'GRAY8', [10, 200]],
    ['grey of 1 bit', { bitDepth: 1, colorType: 0 }, [[0, 0b01000000]], 'GRAY8', [0, 255]],
    ['grey of 4 bits', { bitDepth: 4, colorType: 0 }, [[0, 0x3f]], 'GRAY8', [51, 255]],
    ['grey of 16 bits', { bitDepth: 16, colorType: 0 }, [[0, 9, 1, 8, 2]], 'GRAY8', [9, 8]],
    [
      'colours',
      { bitDepth: 8, colorType: 2 },
      [[0, 1, 2, 3, 4, 5, 6]],
      'RGBA8',
      [1, 2, 3, 255, 4, 5, 6, 255],
    ],
    [
      'grey and opacity',
      { bitDepth: 8, colorType: 4 },
      [[0, 7, 128, 8, 0]],
      'RGBA8',
      [7, 7, 7, 128, 8, 8, 8, 0],
    ],
    [
      'colours and opacity',
      { bitDepth: 8, colorType: 6 },
      [[0, 1, 2, 3, 4, 5, 6, 7, 8]],
      'RGBA8',
      [1, 2, 3, 4, 5, 6, 7, 8],
    ],
  ])('reads %s', async (_what, kind, rows, format, data) => {
    const picture = await decodePicture(png({ width: 2, height: 1, ...kind }, rows));
    expect(picture).toMatchObject({ width: 2, height: 1, format });
    expect([...picture.data]).toEqual(data);
  });

  it('reads a palette with opacity', async () => {
    const more = [
      chunk('PLTE', Uint8Array.of(9, 8, 7, 6, 5, 4)),
      chunk('tRNS', Uint8Array.of(100)),
    ];
    const file = png({ width: 2, height: 1, bitDepth: 2, colorType: 3 }, [[0, 0b01000000]], more);
    expect([...(await decodePicture(file)).data]).toEqual([6, 5, 4, 255, 9, 8, 7, 100]);
  });

  it('undoes all filters', async () => {
    const plain = [
      [10, 20, 40],
      [11, 22, 43],
      [15, 25, 50],
      [12, 30, 60],
      [20, 33, 61],
    ];
    // None, sub, up, average and Paeth, computed by hand from the rows above.
    const rows = [
      [0, 10, 20, 40],
      [1, 11, 11, 21],
      [2, 4, 3, 7],
      [3, 5, 12, 20],
      [4, 8, 3, 1],
    ];
    const file = png({ width: 3, height: 5, bitDepth: 8, colorType: 0 }, rows);
    expect([...(await decodePicture(file)).data]).toEqual(plain.flat());
  });

  it.each([
    [
      'a cut file',
      png({ width: 2, height: 1, bitDepth: 8, colorType: 0 }, [[0, 1, 2]]).slice(0, 50),
    ],
    ['missing rows', png({ width: 2, height: 3, bitDepth: 8, colorType: 0 }, [[0, 1, 2]])],
    ['an unknown filter', png({ width: 2, height: 1, bitDepth: 8, colorType: 0 }, [[5, 1, 2]])],
    [
      'an unknown colour type',
      png({ width: 2, height: 1, bitDepth: 8, colorType: 5 }, [[0, 1, 2]]),
    ],
    [
      'a palette that is missing',
      png({ width: 2, height: 1, bitDepth: 8, colorType: 3 }, [[0, 1, 2]]),
    ],
  ])('refuses %s', async (_what, file) => {
    await expect(decodePicture(file)).rejects.toThrow(
      'The PNG file is damaged. Send the complete file.',
    );
  });

  it('refuses a size that would fill the memory, and interlaced files', async () => {
    const large = png({ width: 60_000, height: 60_000, bitDepth: 8, colorType: 0 }, [[0]]);
    await expect(decodePicture(large)).rejects.toThrow('60000 × 60000 pixels is too large.');
    const woven = png({ width: 1, height: 1, bitDepth: 8, colorType: 0, interlace: 1 }, [[0, 1]]);
    await expect(decodePicture(woven)).rejects.toThrow('The PNG file is interlaced');
  });
});

describe('decodePicture: JPEG', () => {
  it('reads photographs', async () => {
    const picture = await decodePicture(photo('coffee.jpg'));
    const { data, ...expected } = readPhoto('coffee.jpg');
    expect(picture).toMatchObject(expected);
    expect(Buffer.from(picture.data).equals(Buffer.from(data))).toBe(true);
  });

  /** Left half black, right half white; 16 × 8 pixels. */
  const halves = (): Buffer => {
    const data = Buffer.alloc(16 * 8 * 4).map((_, index) => ((index >> 2) % 16 < 8 ? 0 : 255));
    return encode({ width: 16, height: 8, data }, 95).data;
  };
  /** @param order of bytes: II (little endian) or MM */
  const withOrientation = (orientation: number, order: 'II' | 'MM'): Uint8Array => {
    const number = (value: number, bytes: number) => {
      const all = Array.from({ length: bytes }, (_, index) => (value >> (8 * index)) & 255);
      return order === 'II' ? all : all.reverse();
    };
    const exif = [
      ...Buffer.from('Exif\0\0', 'latin1'),
      ...Buffer.from(order, 'latin1'),
      ...number(42, 2),
      ...number(8, 4),
      ...number(1, 2),
      ...[...number(0x0112, 2), ...number(3, 2), ...number(1, 4), ...number(orientation, 2), 0, 0],
      ...number(0, 4),
    ];
    const file = halves();
    const segment = [0xff, 0xe1, 0, exif.length + 2, ...exif];
    return Buffer.concat([file.subarray(0, 2), Uint8Array.from(segment), file.subarray(2)]);
  };

  it.each([
    [1, 'II', 16, 8, 'white at the right'],
    [3, 'MM', 16, 8, 'white at the left'],
    [6, 'II', 8, 16, 'white at the bottom'],
    [8, 'MM', 8, 16, 'white at the top'],
    [77, 'II', 16, 8, 'white at the right'],
  ] as const)(
    'turns orientation %i (%s) upright',
    async (orientation, order, width, height, where) => {
      const picture = await decodePicture(withOrientation(orientation, order));
      expect(picture).toMatchObject({ width, height });
      const at = (x: number, y: number) =>
        picture.data[(Math.floor(y * height) * width + Math.floor(x * width)) * 3]! > 127;
      const found = {
        'white at the left': at(0.1, 0.5) && !at(0.9, 0.5),
        'white at the right': at(0.9, 0.5) && !at(0.1, 0.5),
        'white at the top': at(0.5, 0.1) && !at(0.5, 0.9),
        'white at the bottom': at(0.5, 0.9) && !at(0.5, 0.1),
      };
      expect(found[where]).toBe(true);
    },
  );

  it.each([
    ['a marker without a length', jpegWithDecoy('marker'), 'The JPEG file is damaged.'],
    ['a fill byte', jpegWithDecoy('fill'), '20000 × 20000 pixels is too large.'],
    ['a second frame', jpegFile(9, 9, { after: jpegFrame(20_000, 20_000) }), 'several frames'],
  ])('refuses a size that %s hides [EX-98]', async (_what, file, message) => {
    await expect(decodePicture(file)).rejects.toThrow(message);
  });

  it('refuses cut files', async () => {
    const file = photo('coffee.jpg');
    for (const length of [3, 20, 300, 10_000]) {
      await expect(decodePicture(file.slice(0, length))).rejects.toThrow(
        'The JPEG file is damaged. Send the complete file.',
      );
    }
  });
});

describe('orient', () => {
  // The pixels of a picture of 2 × 3 by orientation: where its first row and column are.
  it.each([
    [1, 2, [1, 2, 3, 4, 5, 6]],
    [2, 2, [2, 1, 4, 3, 6, 5]],
    [3, 2, [6, 5, 4, 3, 2, 1]],
    [4, 2, [5, 6, 3, 4, 1, 2]],
    [5, 3, [1, 3, 5, 2, 4, 6]],
    [6, 3, [5, 3, 1, 6, 4, 2]],
    [7, 3, [6, 4, 2, 5, 3, 1]],
    [8, 3, [2, 4, 6, 1, 3, 5]],
  ])('turns orientation %i upright', (orientation, width, pixels) => {
    const data = Uint8Array.of(1, 2, 3, 4, 5, 6);
    const picture = orient({ width: 2, height: 3, format: 'GRAY8', data }, orientation);
    expect(picture.width).toBe(width);
    expect([...picture.data]).toEqual(pixels);
  });
});

describe('readImage2D', () => {
  it('reads raw pixels and files', async () => {
    const data = Uint8Array.of(1, 2);
    expect(await readImage2D({ width: 2, height: 1, dataFormat: 0, data })).toMatchObject({ data });
    // Size and format of the message are not those of the file.
    const picture = await readImage2D({ width: 640, height: 480, data: photo('chelsea.jpg') });
    expect(picture).toMatchObject({ width: 451, height: 300, format: 'RGB8' });
  });

  it('refuses what is neither', async () => {
    await expect(readImage2D({ width: 2, height: 2, data: Uint8Array.of(1) })).rejects.toThrow(
      'The picture has 1 bytes instead of 4 (2 × 2 pixels, GRAY8).',
    );
    await expect(decodePicture(Uint8Array.of(1))).rejects.toThrow(
      'The file is not a picture. Send JPEG, PNG or WebP.',
    );
    await expect(decodePicture(new TextEncoder().encode('RIFF1234WEBP'))).rejects.toThrow(
      'WebP files cannot be decoded here. Send JPEG or PNG.',
    );
  });
});
