import { DATA_FORMATS, type DataFormat } from '@ubii/proto';

/** Kind of editor for the values of a data format. */
export type FieldKind = 'number' | 'switch' | 'text' | 'parts' | 'color' | 'json';

const KINDS: { readonly [F in DataFormat]?: FieldKind } = {
  double: 'number',
  float: 'number',
  int32: 'number',
  bool: 'switch',
  string: 'text',
  vector2: 'parts',
  vector3: 'parts',
  vector4: 'parts',
  quaternion: 'parts',
  color: 'color',
};

/** Members of values that consist of numbers only. */
const PARTS: { readonly [F in DataFormat]?: readonly string[] } = {
  vector2: ['x', 'y'],
  vector3: ['x', 'y', 'z'],
  vector4: ['x', 'y', 'z', 'w'],
  quaternion: ['x', 'y', 'z', 'w'],
  color: ['r', 'g', 'b', 'a'],
};

export const fieldKind = (format: DataFormat): FieldKind => KINDS[format] ?? 'json';

export const partNames = (format: DataFormat): readonly string[] => PARTS[format] ?? [];

/** Whether users can type values of this format: not for pictures and lists. */
export function isTypable(format: DataFormat): boolean {
  const { isList, family } = DATA_FORMATS[format];
  return !isList && family !== 'image' && family !== 'system';
}

/** Returns the value in a constant such as `{"double":1}`; undefined when it is invalid. */
export function valueOf(format: DataFormat, json: string): unknown {
  try {
    const record: unknown = JSON.parse(json);
    return typeof record === 'object' && record !== null
      ? (record as Record<string, unknown>)[format]
      : undefined;
  } catch {
    return undefined;
  }
}

/** Returns the numbers of a constant, in the order of `partNames`; 0 for missing ones. */
export function partsOf(format: DataFormat, json: string | undefined): readonly number[] {
  const value = json === undefined ? undefined : valueOf(format, json);
  const members = (typeof value === 'object' && value !== null ? value : {}) as object;
  return partNames(format).map((name) => numberOf((members as Record<string, unknown>)[name]));
}

/** Returns the constant with one number replaced. */
export function withPart(
  format: DataFormat,
  json: string | undefined,
  name: string,
  next: number,
): string {
  const numbers = partsOf(format, json);
  const members = partNames(format).map((part, index) => [
    part,
    part === name ? next : numbers[index],
  ]);
  return JSON.stringify({ [format]: Object.fromEntries(members) as object });
}

/** Converts a colour with parts from 0 to 1 to `#rrggbb`. */
export function hexOf(parts: readonly number[]): string {
  const two = (part = 0): string =>
    Math.round(Math.min(1, Math.max(0, part)) * 255)
      .toString(16)
      .padStart(2, '0');
  return `#${two(parts[0])}${two(parts[1])}${two(parts[2])}`;
}

/** Returns the colour constant with another colour; the opacity stays. */
export function withHex(json: string | undefined, hex: string): string {
  const part = (at: number): number =>
    Math.round((parseInt(hex.slice(at, at + 2), 16) / 255) * 1000) / 1000;
  const alpha = json === undefined ? 1 : (partsOf('color', json)[3] ?? 1);
  return JSON.stringify({ color: { r: part(1), g: part(3), b: part(5), a: alpha } });
}

const numberOf = (value: unknown): number => (typeof value === 'number' ? value : 0);
