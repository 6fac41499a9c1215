import { jpegFile } from '@ubii/pictures/testing';
import { Image2DDataFormat, type Image2D } from '@ubii/proto';
import { expect, it } from 'vitest';
import { overlayTopics } from './overlay-topics.ts';
import { encodingOf, pictureNote, pictureProblem } from './picture-facts.ts';

const image = (
  width: number,
  height: number,
  dataFormat: number,
  data: number | number[],
): Image2D => ({
  width,
  height,
  dataFormat: dataFormat as Image2DDataFormat,
  data: new Uint8Array(data as number),
});
const { GRAY8, RGB8 } = Image2DDataFormat;

it('says what the size needs, what there is, and what it would fit', () => {
  expect(pictureProblem(image(2, 2, RGB8, 12))).toBeUndefined();
  expect(pictureProblem(image(2, 2, RGB8, 4))).toBe(
    'The data is too short for the size of the picture: 2 × 2 RGB8 needs 12 bytes, and the record has 4. The data matches the format GRAY8.',
  );
  expect(pictureProblem(image(2, 2, 9, 4))).toMatch(/layout 9 is not GRAY8/);
  expect(pictureProblem(image(0, 2, GRAY8, 4))).toMatch(/0 × 2 pixels/);
  expect(pictureProblem(image(2, 2, GRAY8, 0))).toMatch(/empty/);
});

it('says why a picture is refused [EX-98]', () => {
  const file = (data: Uint8Array): Image2D => image(9, 9, RGB8, [...data]);
  expect(pictureProblem(file(jpegFile(9, 9)))).toBeUndefined();
  expect(pictureProblem(file(jpegFile(20_000, 20_000, { scanBytes: 9 })))).toBe(
    'A picture of 20000 × 20000 pixels is too large. At most 16 megapixels (2^20) and 16384 pixels a side are possible.',
  );
  expect(pictureProblem(file(jpegFile(9, 9).subarray(0, 20)))).toBe(
    'The JPEG file is damaged. Send the complete file.',
  );
  expect(pictureProblem(image(20_000, 1, GRAY8, 20_000))).toMatch(/^A picture of 20000 × 1 pixels/);
});

it('knows files by their first bytes, and says when the record says another size', () => {
  const jpeg = image(640, 480, RGB8, [0xff, 0xd8, 0xff, 0xe0]);
  expect(encodingOf(jpeg)).toBe('JPEG');
  expect(pictureNote(jpeg, { width: 640, height: 480 })).toBeUndefined();
  expect(pictureNote(jpeg, { width: 320, height: 240 })).toMatch(/but its JPEG is 320 × 240/);
  expect(pictureNote(image(2, 2, GRAY8, 7), { width: 2, height: 2 })).toMatch(
    /^The data has 3 bytes more/,
  );
});

it('suggests things and poses near the picture first', () => {
  const known = [
    ['/a/point', 'vector2'],
    ['/b/things', 'object2DList'],
    ['/cam/1/things', 'ubii.dataStructure.Object2DList'],
    ['/cam/1/image', 'image2D'],
    ['/cam/1/speed', 'double'],
  ] as const;
  expect(overlayTopics(known, '/cam/1/image')).toEqual(['/cam/1/things', '/b/things', '/a/point']);
});
