import { Image2DDataFormat } from '../generated/messages.ts';

const CHANNELS: { readonly [dataFormat: number]: number } = {
  [Image2DDataFormat.GRAY8]: 1,
  [Image2DDataFormat.RGB8]: 3,
  [Image2DDataFormat.RGBA8]: 4,
};

/**
 * First bytes of the compressed pictures that clients send in `data` although the schema has no
 * format for them: JPEG, PNG, and WebP (a RIFF container).
 */
const COMPRESSED_STARTS: readonly (readonly number[])[] = [
  [0xff, 0xd8, 0xff],
  [0x89, 0x50, 0x4e, 0x47],
  [0x52, 0x49, 0x46, 0x46],
];

/**
 * Checks that a picture has as many bytes as its size says: width times height times channels.
 * Compressed pictures, known by their first bytes, are not measured: their data says its own size.
 *
 * @returns undefined when fine, else one sentence
 */
export function validateImage(
  image: Readonly<Record<string, unknown>>,
  name: string,
): string | undefined {
  const width = Number(image['width'] ?? 0);
  const height = Number(image['height'] ?? 0);
  const channels = CHANNELS[Number(image['dataFormat'] ?? 0)] ?? 0;
  const data = (image['data'] ?? new Uint8Array(0)) as Uint8Array;
  if (width < 0 || height < 0)
    return `${name} must not be smaller than 0 by 0, got ${width} by ${height}.`;
  if (isCompressedImage(data)) return undefined;
  const expected = width * height * channels;
  if (data.length === expected) return undefined;
  return `${name}.data must be ${expected} bytes for ${width} by ${height} pixels of ${channels} bytes, got ${data.length}.`;
}

/** True when the data of a picture begins like a JPEG, PNG or WebP file. */
export function isCompressedImage(data: Uint8Array): boolean {
  return COMPRESSED_STARTS.some((start) => start.every((byte, i) => data[i] === byte));
}
