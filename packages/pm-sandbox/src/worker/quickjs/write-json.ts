/** Inputs as text and the bytes that are no text. */
export interface WrittenJson {
  readonly json: string;
  /** Each with memory of its own; `{"$":0}` in the text stands for the first. */
  readonly blobs: readonly ArrayBuffer[];
  /** Whether there are marks in the text. */
  readonly hasMarks: boolean;
}

/**
 * Writes decoded inputs as JSON text. Bytes and NaN, which JSON cannot say, become objects with the
 * one member `$`, which no message of the schema has.
 */
export function writeJson(value: unknown): WrittenJson {
  const blobs: ArrayBuffer[] = [];
  let hasMarks = false;

  const write = (part: unknown): string => {
    switch (typeof part) {
      case 'number':
        return writeNumber(part);
      case 'string':
        return JSON.stringify(part);
      case 'boolean':
        return part ? 'true' : 'false';
      case 'object':
        if (part === null) return 'null';
        if (Array.isArray(part)) return writeArray(part);
        return part instanceof Uint8Array ? writeBytes(part) : writeObject(part);
      default:
        return 'null';
    }
  };
  const writeNumber = (number: number): string => {
    if (number === 0) return 1 / number < 0 ? '-0' : '0';
    if (Number.isFinite(number)) return String(number);
    // A number too big for JSON is read as infinite.
    if (!Number.isNaN(number)) return number > 0 ? '1e999' : '-1e999';
    hasMarks = true;
    return '{"$":"NaN"}';
  };
  const writeArray = (array: readonly unknown[]): string => {
    let text = '';
    for (let i = 0; i < array.length; i++)
      text += i === 0 ? write(array[i]) : `,${write(array[i])}`;
    return `[${text}]`;
  };
  const writeBytes = (bytes: Uint8Array): string => {
    hasMarks = true;
    const isWhole = bytes.byteLength === bytes.buffer.byteLength;
    blobs.push((isWhole ? bytes : bytes.slice()).buffer as ArrayBuffer);
    return `{"$":${blobs.length - 1}}`;
  };
  const writeObject = (object: object): string => {
    let text = '';
    for (const [key, member] of Object.entries(object)) {
      if (member === undefined) continue;
      const entry = `${JSON.stringify(key)}:${write(member)}`;
      text += text === '' ? entry : `,${entry}`;
    }
    return `{${text}}`;
  };

  return { json: write(value), blobs, hasMarks };
}
