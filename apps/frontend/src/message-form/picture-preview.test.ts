import { jpegFile, webpFile, webpLossy } from '@ubii/pictures/testing';
import { expect, it } from 'vitest';
import { base64Of } from './base64.ts';
import { previewOf } from './picture-preview.ts';

it('shows the file of a message', () => {
  const jpeg = jpegFile(40, 30);
  expect(previewOf(base64Of(jpeg))).toEqual({ url: `data:image/jpeg;base64,${base64Of(jpeg)}` });
  expect(previewOf(base64Of(webpFile(webpLossy(40, 30))))?.url).toMatch(/^data:image\/webp;/);
});

it('says why a file of many pixels is not shown [EX-98]', () => {
  expect(previewOf(base64Of(jpegFile(20_000, 20_000, { scanBytes: 9 })))).toEqual({
    problem: expect.stringContaining('A picture of 20000 × 20000 pixels is too large.'),
  });
});

it.each([[undefined], [''], ['no base64'], [base64Of(Uint8Array.of(1, 2, 3))]])(
  'has none of %s',
  (data) => {
    expect(previewOf(data)).toBeUndefined();
  },
);
