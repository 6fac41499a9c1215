/**
 * Deep equality of values of messages and of what is made of them: plain objects, lists, maps and bytes. The order of
 * members does not count, and a member that is undefined counts as missing. `NaN` equals `NaN`; 0 and -0 differ.
 */
export function isSameValue(a: unknown, b: unknown): boolean {
  if (Object.is(a, b)) return true;
  if (typeof a !== 'object' || typeof b !== 'object' || a === null || b === null) return false;
  if (a instanceof Map || b instanceof Map) return isSameMap(a, b);
  if (isList(a) || isList(b)) return isList(a) && isList(b) && isSameList(a, b);
  // Undefined members count as missing.
  const [left, right] = [definedKeys(a), definedKeys(b)];
  return (
    left.length === right.length &&
    left.every(
      (key) =>
        Object.hasOwn(b, key) &&
        isSameValue((a as Record<string, unknown>)[key], (b as Record<string, unknown>)[key]),
    )
  );
}

function isSameMap(a: object, b: object): boolean {
  if (!(a instanceof Map) || !(b instanceof Map) || a.size !== b.size) return false;
  return [...a].every(([key, value]) => b.has(key) && isSameValue(value, b.get(key)));
}

const isList = (value: object): value is ArrayLike<unknown> =>
  Array.isArray(value) || value instanceof Uint8Array;

function isSameList(a: ArrayLike<unknown>, b: ArrayLike<unknown>): boolean {
  if (a.length !== b.length) return false;
  for (let i = 0; i < a.length; i += 1) if (!isSameValue(a[i], b[i])) return false;
  return true;
}

const definedKeys = (value: object): string[] =>
  Object.keys(value).filter((key) => (value as Record<string, unknown>)[key] !== undefined);
