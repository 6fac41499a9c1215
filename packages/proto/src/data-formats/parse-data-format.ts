import type { DataFormat } from './data-format-values.ts';
import { DATA_FORMATS } from './data-formats.ts';

/** Spellings found in deployed applications and on other platforms that no rule yields. */
const ALIASES: readonly (readonly [string, DataFormat])[] = [
  ['boolean', 'bool'],
  ['booleanlist', 'boolList'],
  ['number', 'double'],
  ['int', 'int32'],
  ['integer', 'int32'],
  ['intlist', 'int32List'],
  ['str', 'string'],
  ['text', 'string'],
  ['image', 'image2D'],
  ['imagelist', 'image2DList'],
];

const FORMAT_BY_SPELLING: ReadonlyMap<string, DataFormat> = new Map<string, DataFormat>([
  ...Object.values(DATA_FORMATS).map(({ format }) => [format.toLowerCase(), format] as const),
  ...ALIASES,
]);

/**
 * Finds the data format a text means: short names (`vector2`), names of the schema
 * (`vector2_list`), full names (`ubii.dataStructure.Vector2`), any case, and the spellings of
 * deployed applications (`boolean`, `ubii.dataStructure.Image`).
 *
 * @returns undefined when it is none; texts like that occur and must be accepted as a device's
 * message format, so this is never a reason to refuse a registration
 */
export function parseDataFormat(text: string): DataFormat | undefined {
  const dot = text.lastIndexOf('.');
  const prefix = text.slice(0, dot + 1).trim();
  if (prefix !== '' && !prefix.startsWith('ubii.')) return undefined;
  const spelling = text
    .slice(dot + 1)
    .trim()
    .replaceAll('_', '')
    .toLowerCase();
  return FORMAT_BY_SPELLING.get(spelling);
}
