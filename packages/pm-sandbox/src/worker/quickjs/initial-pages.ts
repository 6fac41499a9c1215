const IMPORTS = 2;
const HEADER_BYTES = 8;
const MEMORY = 2;

/**
 * Lets a compiled program begin with fewer pages of the memory that it imports. It is compiled to ask
 * for 16 MiB, most of which it never touches: what is asked for is what can be counted.
 *
 * @returns undefined when the program imports no memory, or the number does not fit into its place
 */
export function withInitialPages(program: Uint8Array, pages: number): Uint8Array | undefined {
  const reader = new Reader(program, HEADER_BYTES);
  while (reader.at < program.length) {
    const section = reader.byte();
    const end = reader.number() + reader.at;
    if (section !== IMPORTS) {
      reader.at = end;
      continue;
    }
    for (let left = reader.number(); left > 0; left--) {
      reader.skipName();
      reader.skipName();
      const kind = reader.byte();
      if (kind === MEMORY) return withNumberAt(program, reader.at + 1, pages);
      // Functions have a type; this program imports nothing else before its memory.
      if (kind !== 0) return undefined;
      reader.number();
    }
    return undefined;
  }
  return undefined;
}

/** Writes a number over another one, as long as that is. */
function withNumberAt(program: Uint8Array, at: number, value: number): Uint8Array | undefined {
  const reader = new Reader(program, at);
  reader.number();
  const length = reader.at - at;
  if (value >= 2 ** (7 * length)) return undefined;
  const changed = program.slice();
  for (let i = 0; i < length; i++) {
    const more = i < length - 1 ? 0x80 : 0;
    changed[at + i] = ((value >>> (7 * i)) & 0x7f) | more;
  }
  return changed;
}

class Reader {
  readonly #bytes: Uint8Array;
  at: number;

  constructor(bytes: Uint8Array, at: number) {
    this.#bytes = bytes;
    this.at = at;
  }

  byte(): number {
    return this.#bytes[this.at++] ?? 0;
  }

  /** LEB128. */
  number(): number {
    let value = 0;
    for (let factor = 1; ; factor *= 128) {
      const byte = this.byte();
      value += (byte & 0x7f) * factor;
      if (byte < 0x80) return value;
    }
  }

  skipName(): void {
    const length = this.number();
    this.at += length;
  }
}
