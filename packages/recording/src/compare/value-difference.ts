/** Which numbers are the same: those within either tolerance. */
export interface ValueTolerance {
  /** Of the larger of two numbers; 0 for exactly equal ones. */
  readonly relativeTolerance: number;
  readonly absoluteTolerance: number;
}

/**
 * Finds the first member in which two decoded values differ.
 *
 * @returns its path, such as `position.x`, `elements.0.id`, or empty for the value itself; undefined when they are the same
 */
export function findDifference(
  a: unknown,
  b: unknown,
  tolerance: ValueTolerance,
): string | undefined {
  if (a === b) return undefined;
  if (typeof a === 'number' && typeof b === 'number')
    return areClose(a, b, tolerance) ? undefined : '';
  if (!isObject(a) || !isObject(b)) return '';
  if (ArrayBuffer.isView(a) || ArrayBuffer.isView(b)) return haveSameBytes(a, b) ? undefined : '';
  const members = new Set([...Object.keys(a), ...Object.keys(b)]);
  for (const member of members) {
    const path = findDifference(a[member], b[member], tolerance);
    if (path !== undefined) return path === '' ? member : `${member}.${path}`;
  }
  return undefined;
}

function areClose(a: number, b: number, tolerance: ValueTolerance): boolean {
  if (Number.isNaN(a) && Number.isNaN(b)) return true;
  const { relativeTolerance, absoluteTolerance } = tolerance;
  const larger = Math.max(Math.abs(a), Math.abs(b));
  if (!Number.isFinite(larger)) return false;
  return Math.abs(a - b) <= Math.max(absoluteTolerance, relativeTolerance * larger);
}

const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null;

function haveSameBytes(a: unknown, b: unknown): boolean {
  if (!(a instanceof Uint8Array) || !(b instanceof Uint8Array) || a.length !== b.length)
    return false;
  return a.every((byte, place) => byte === b[place]);
}
