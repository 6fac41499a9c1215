/** Numbers that JSON cannot say, by their marks. */
const NUMBERS: Readonly<Record<string, number>> = {
  NaN,
  Infinity,
  '-Infinity': -Infinity,
  '-0': -0,
};

/**
 * Parses text from inside the engine, marks included. What it yields has own members only, also when
 * they are called `__proto__`. [PM-56]
 *
 * @throws SyntaxError when it is no JSON
 * @throws RangeError when it is nested too deeply
 */
export function parseJson(
  text: string,
  blobOf: (index: number) => Uint8Array | undefined,
): unknown {
  const root = JSON.parse(text) as unknown;
  return text.includes('{"$":') ? revive(root, blobOf) : root;
}

function revive(value: unknown, blobOf: (index: number) => Uint8Array | undefined): unknown {
  if (typeof value !== 'object' || value === null) return value;
  if (Array.isArray(value)) {
    for (let i = 0; i < value.length; i++) value[i] = revive(value[i], blobOf);
    return value;
  }
  const object = value as Record<string, unknown>;
  if (Object.hasOwn(object, '$')) return unmark(object['$'], blobOf);
  for (const key of Object.keys(object)) {
    if (key !== '__proto__') object[key] = revive(object[key], blobOf);
  }
  return object;
}

/** Values that cannot be transferred are represented by a symbol, which no member accepts. [PM-56] */
function unmark(mark: unknown, blobOf: (index: number) => Uint8Array | undefined): unknown {
  if (typeof mark === 'number') return blobOf(mark);
  if (typeof mark !== 'string' || mark === 'undefined') return undefined;
  return Object.hasOwn(NUMBERS, mark) ? NUMBERS[mark] : Symbol.for(mark);
}
