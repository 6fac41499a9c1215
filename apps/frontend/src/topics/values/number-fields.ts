import type { DataFormat } from '@ubii/proto';

/** Numbers of one value that are found; what is beyond can still be asked for by its path. */
export const MAX_FIELDS = 64;
/** Elements of one list that are looked into, */
const MAX_ELEMENTS = 16;
/** and how deep. */
const MAX_DEPTH = 6;
/** Longer texts are not looked into for numbers. */
const MAX_PARSED = 65_536;
/** Letters of a path. */
export const MAX_PATH = 200;

/**
 * Where the numbers of a value stand: `pose.position.x`, `elements.0.id`; empty for a value that is a
 * number itself. A bool is 0 or 1, and a text that is JSON is looked into.
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

/** What fields are read from: the value, or what its text says in JSON. */
export function readable(format: DataFormat, value: unknown): unknown {
  if (format !== 'string' || typeof value !== 'string') return value;
  if (value.length > MAX_PARSED || !/^\s*[-\d[{tf]/.test(value)) return undefined;
  try {
    return JSON.parse(value) as unknown;
  } catch {
    return undefined; // it only begins like JSON
  }
}

/** The number at a path; NaN where there is none. @param parts of the path; none for the value itself */
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
