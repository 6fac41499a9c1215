/**
 * Parses a path into JSON, such as `values[0].celsius`.
 *
 * @returns members and indices; empty for the whole value
 * @throws Error with the expected value, to follow "must be"
 */
export function parseField(text: string): readonly (string | number)[] {
  if (text === '') return [];
  const steps: (string | number)[] = [];
  for (const part of text.split('.')) {
    const match = /^([^[\].]*)((?:\[\d{1,6}\])*)$/.exec(part);
    const [, name = '', indices = ''] = match ?? [];
    if (match === null || (name === '' && (indices === '' || steps.length > 0))) {
      throw new Error('members and indices, such as values[0].celsius');
    }
    if (name !== '') steps.push(name);
    for (const [, index] of indices.matchAll(/\[(\d+)\]/g)) steps.push(Number(index));
  }
  return steps;
}

/** Returns what is at the path; `undefined` when there is nothing. */
export function readField(value: unknown, field: readonly (string | number)[]): unknown {
  let found = value;
  for (const step of field) {
    if (typeof found !== 'object' || found === null || !Object.hasOwn(found, step))
      return undefined;
    found = (found as Readonly<Record<string | number, unknown>>)[step];
  }
  return found;
}

/** Returns the value inside the objects and lists of the path. */
export function writeField(value: unknown, field: readonly (string | number)[]): unknown {
  return field.reduceRight<unknown>((inner, step) => {
    if (typeof step === 'string') return { [step]: inner };
    const list: unknown[] = Array.from({ length: step }, () => null);
    return [...list, inner];
  }, value);
}
