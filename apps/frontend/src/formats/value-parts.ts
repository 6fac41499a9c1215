import { DATA_FORMATS, type DataFormat } from '@ubii/proto';

/** How a value of a data format is edited. */
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

/** The members of values that are nothing but numbers. */
const PARTS: { readonly [F in DataFormat]?: readonly string[] } = {
  vector2: ['x', 'y'],
  vector3: ['x', 'y', 'z'],
  vector4: ['x', 'y', 'z', 'w'],
  quaternion: ['x', 'y', 'z', 'w'],
  color: ['r', 'g', 'b', 'a'],
};

export const fieldKind = (format: DataFormat): FieldKind => KINDS[format] ?? 'json';

export const partNames = (format: DataFormat): readonly string[] => PARTS[format] ?? [];

/** Whether people type such values at all: pictures and lists come from elsewhere. */
export function isTypable(format: DataFormat): boolean {
  const { isList, family } = DATA_FORMATS[format];
  return !isList && family !== 'image' && family !== 'system';
}

/** The value in a constant such as `{"double":1}`; undefined when it cannot be read. */
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

/** The numbers of a constant, in the order of `partNames`; 0 where one is missing. */
export function partsOf(format: DataFormat, json: string | undefined): readonly number[] {
  const value = json === undefined ? undefined : valueOf(format, json);
  const members = (typeof value === 'object' && value !== null ? value : {}) as object;
  return partNames(format).map((name) => numberOf((members as Record<string, unknown>)[name]));
}

/** The constant with another number at one of its members. */
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

/** `#rrggbb` of a colour whose parts go from 0 to 1. */
export function hexOf(parts: readonly number[]): string {
  const two = (part = 0): string =>
    Math.round(Math.min(1, Math.max(0, part)) * 255)
      .toString(16)
      .padStart(2, '0');
  return `#${two(parts[0])}${two(parts[1])}${two(parts[2])}`;
}

/** The colour constant with another hue; how opaque it is stays. */
export function withHex(json: string | undefined, hex: string): string {
  const part = (at: number): number =>
    Math.round((parseInt(hex.slice(at, at + 2), 16) / 255) * 1000) / 1000;
  const alpha = json === undefined ? 1 : (partsOf('color', json)[3] ?? 1);
  return JSON.stringify({ color: { r: part(1), g: part(3), b: part(5), a: alpha } });
}

const numberOf = (value: unknown): number => (typeof value === 'number' ? value : 0);
