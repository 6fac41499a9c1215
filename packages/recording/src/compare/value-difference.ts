/** Numbers closer to zero than this are zero. */
const SMALLEST = 1e-12;

/**
 * Finds the first member in which two decoded values differ.
 *
 * @param relativeTolerance of the larger of two numbers; 0 for exactly equal ones
 * @returns its path, such as `position.x`, `elements.0.id`, or empty for the value itself; undefined when they are the same
 */
export function findDifference(
  a: unknown,
  b: unknown,
  relativeTolerance: number,
): string | undefined {
  if (a === b) return undefined;
  if (typeof a === 'number' && typeof b === 'number')
    return areClose(a, b, relativeTolerance) ? undefined : '';
  if (!isObject(a) || !isObject(b)) return '';
  if (ArrayBuffer.isView(a) || ArrayBuffer.isView(b)) return haveSameBytes(a, b) ? undefined : '';
  const members = new Set([...Object.keys(a), ...Object.keys(b)]);
  for (const member of members) {
    const path = findDifference(a[member], b[member], relativeTolerance);
    if (path !== undefined) return path === '' ? member : `${member}.${path}`;
  }
  return undefined;
}

function areClose(a: number, b: number, relativeTolerance: number): boolean {
  if (Number.isNaN(a) || Number.isNaN(b)) return Number.isNaN(a) && Number.isNaN(b);
  const larger = Math.max(Math.abs(a), Math.abs(b));
  return larger < SMALLEST || Math.abs(a - b) <= relativeTolerance * larger;
}

const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null;

function haveSameBytes(a: unknown, b: unknown): boolean {
  if (!(a instanceof Uint8Array) || !(b instanceof Uint8Array) || a.length !== b.length)
    return false;
  return a.every((byte, place) => byte === b[place]);
}
