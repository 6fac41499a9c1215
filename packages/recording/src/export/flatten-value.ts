/** A number, truth value or text of a table; undefined where a record has none. */
export type Cell = number | boolean | string | undefined;

/**
 * The leaves of a decoded value with their paths: `x` of a vector, `0.x` of the first vector of a list (the member
 * `elements` is left out), `value` of a single number or text. Of bytes, such as pixels, only the length is given, as
 * `data.byteLength`.
 *
 * @param visit is called for each leaf, in the order of the members
 */
export function flattenValue(value: unknown, visit: (path: string, cell: Cell) => void): void {
  flatten(value, '', visit);
}

function flatten(value: unknown, path: string, visit: (path: string, cell: Cell) => void): void {
  if (value === undefined || value === null) return;
  if (value instanceof Uint8Array) return visit(join(path, 'byteLength'), value.byteLength);
  if (typeof value !== 'object') {
    const isPlain = ['number', 'boolean', 'string'].includes(typeof value);
    return visit(path === '' ? 'value' : path, isPlain ? (value as Cell) : String(value));
  }
  for (const [member, child] of Object.entries(value)) {
    flatten(child, member === 'elements' ? path : join(path, member), visit);
  }
}

function join(path: string, member: string): string {
  return path === '' ? member : `${path}.${member}`;
}
