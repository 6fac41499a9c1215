import type { DataFormat } from '@ubii/proto';

/** Most numbers found per value; others can still be requested by path. */
export const MAX_FIELDS = 64;
/** Most elements searched per list, */
const MAX_ELEMENTS = 16;
/** and deepest level. */
const MAX_DEPTH = 6;
/** Longest text that is searched for numbers, characters. */
const MAX_PARSED = 65_536;
/** Longest path, characters. */
export const MAX_PATH = 200;

/**
 * Returns the paths of the numbers in a value: `pose.position.x`, `elements.0.id`; empty for a value that is a number
 * itself. A bool counts as 0 or 1; a text with JSON is parsed.
 */
export function numberFields(format: DataFormat, value: unknown): string[] {
  const paths: string[] = [];
  const visit = (child: unknown, path: string, depth: number): void => {
    if (paths.length >= MAX_FIELDS || path.length > MAX_PATH) return;
    if (typeof child === 'number' || typeof child === 'boolean') {
      paths.push(path);
      return;
    }
    if (typeof child !== 'object' || child === null || depth > MAX_DEPTH) return;
    if (ArrayBuffer.isView(child)) return;
    const entries = Object.entries(child);
    for (const [name, member] of Array.isArray(child) ? entries.slice(0, MAX_ELEMENTS) : entries) {
      if (name.includes('.')) continue; // no path leads to it
      visit(member, path === '' ? name : `${path}.${name}`, depth + 1);
    }
  };
  visit(readable(format, value), '', 0);
  return paths;
}

/** Returns the object that paths refer to: the value, or the parsed JSON of a text. */
export function readable(format: DataFormat, value: unknown): unknown {
  if (format !== 'string' || typeof value !== 'string') return value;
  if (value.length > MAX_PARSED || !/^\s*[-\d[{tf]/.test(value)) return undefined;
  try {
    return JSON.parse(value) as unknown;
  } catch {
    return undefined; // Starts like JSON, but is not.
  }
}

/** Returns the number at a path; NaN without one. @param parts of the path; empty for the value itself */
export function readNumber(value: unknown, parts: readonly string[]): number {
  let at = value;
  for (const part of parts) {
    if (typeof at !== 'object' || at === null || !Object.hasOwn(at, part)) return Number.NaN;
    at = (at as Record<string, unknown>)[part];
  }
  if (typeof at === 'boolean') return at ? 1 : 0;
  return typeof at === 'number' ? at : Number.NaN;
}

export const partsOf = (path: string): readonly string[] => (path === '' ? [] : path.split('.'));
