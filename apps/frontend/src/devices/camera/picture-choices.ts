import type { PictureEncoding, PictureSettings } from './encode-picture.ts';

/** Pixels. */
export const WIDTHS: readonly number[] = [160, 320, 640];
/** Hertz. */
export const RATES: readonly number[] = [1, 5, 10, 30];
export const ENCODINGS: readonly {
  readonly value: PictureEncoding;
  readonly text: string;
  readonly hint: string;
}[] = [
  { value: 'RGB8', text: 'RGB8', hint: 'raw, readable by every program' },
  { value: 'RGBA8', text: 'RGBA8', hint: 'raw, with opacity' },
  { value: 'GRAY8', text: 'GRAY8', hint: 'raw, brightness' },
  { value: 'JPEG', text: 'JPEG', hint: 'a file, a tenth as large' },
];
/** Range of JPEG qualities. */
export const QUALITIES = { min: 0.1, max: 0.95, step: 0.05 };

export const FIRST_SETTINGS: Readonly<PictureSettings> = {
  width: 320,
  rateHz: 10,
  encoding: 'RGB8',
  quality: 0.7,
};
