const QUOTE = 0x22;
const BACKSLASH = 0x5c;
const COMMA = 0x2c;
const COLON = 0x3a;
const OPEN_LIST = 0x5b;
const CLOSE_LIST = 0x5d;
const OPEN_OBJECT = 0x7b;
const CLOSE_OBJECT = 0x7d;

/** A member's value is read up to here, bytes: topics are shorter. */
const MAX_TEXT_BYTES = 8 * 1024;
/** The longest way to write a key of so few letters: each escaped, with quotes. */
const BYTES_PER_KEY_CHAR = 6;

/** Limits of a scan. */
export interface JsonScanLimits {
  /** Objects and lists within each other. */
  readonly depth: number;
  /** Texts, numbers, truth values, nulls, objects and lists. */
  readonly values: number;
}

/** Limit that a scan exceeded, at the position `pos`. */
export type JsonScanExcess = 'depth' | 'values';

/**
 * Counts the values of a JSON text and finds one text member of the outermost object, without parsing
 * or allocating: a byte costs about a nanosecond. The text may come in pieces, and need not be valid:
 * no parser makes more values of it, or deeper ones, before it fails. [SV-43]
 */
export class JsonScan {
  /** Next byte to look at. */
  pos = 0;
  /** Never less than the values a parser would make of what was scanned. */
  values = 1;
  readonly #member: string;
  #text: string | undefined = undefined;
  #depth = 0;
  #isInString = false;
  #isEscaped = false;
  #hasEscapes = false;
  #stringStart = 0;
  /** The outermost value is an object. */
  #isObject = false;
  /** The next text in the outermost object is a key. */
  #isKey = false;
  /** The member that is looked for stands before the next value. */
  #isMember = false;

  /** @param member name of the member to find, ASCII */
  constructor(member: string) {
    this.#member = member;
  }

  /** The member's text, of several the last; undefined while there is none, or when it is no text. */
  get text(): string | undefined {
    return this.#text;
  }

  /**
   * Reads on.
   *
   * @param bytes the text from its beginning
   * @param end first byte that has not come yet
   * @returns what there is too much of; undefined: nothing so far
   */
  scan(bytes: Uint8Array, end: number, limits: JsonScanLimits): JsonScanExcess | undefined {
    let { pos, values } = this;
    let isInString = this.#isInString;
    let isEscaped = this.#isEscaped;
    let excess: JsonScanExcess | undefined;
    for (; pos < end; pos++) {
      const byte = bytes[pos]!;
      if (isInString) {
        if (isEscaped) isEscaped = false;
        else if (byte === BACKSLASH) isEscaped = this.#hasEscapes = true;
        else if (byte === QUOTE) {
          isInString = false;
          if (this.#depth === 1) this.#endText(bytes, pos);
        }
        continue;
      }
      switch (byte) {
        case QUOTE:
          isInString = true;
          this.#stringStart = pos;
          this.#hasEscapes = false;
          break;
        case COMMA:
          values++;
          if (this.#depth === 1) this.#isKey = this.#isObject;
          break;
        case COLON:
          if (this.#depth === 1) this.#isKey = false;
          break;
        case OPEN_LIST:
        case OPEN_OBJECT:
          values++;
          if (++this.#depth === 1) this.#isKey = this.#isObject = byte === OPEN_OBJECT;
          else if (this.#depth === 2 && this.#isMember) this.#forget();
          if (this.#depth > limits.depth) excess = 'depth';
          break;
        case CLOSE_LIST:
        case CLOSE_OBJECT:
          this.#depth--;
          break;
        default:
          // A number, null, true or false where the text would be.
          if (this.#isMember && this.#depth === 1 && byte > 0x20) this.#forget();
      }
      if (values > limits.values) excess ??= 'values';
      if (excess !== undefined) break;
    }
    this.pos = pos;
    this.values = values;
    this.#isInString = isInString;
    this.#isEscaped = isEscaped;
    return excess;
  }

  #forget(): void {
    this.#isMember = false;
    this.#text = undefined;
  }

  #endText(bytes: Uint8Array, end: number): void {
    const start = this.#stringStart;
    if (!this.#isKey) {
      if (this.#isMember)
        this.#text = this.#read(bytes, start, Math.min(end + 1, start + MAX_TEXT_BYTES));
      this.#isMember = false;
      return;
    }
    const length = end - start - 1;
    const { length: memberLength } = this.#member;
    this.#isMember =
      length >= memberLength &&
      length <= BYTES_PER_KEY_CHAR * memberLength &&
      (length === memberLength || this.#hasEscapes) &&
      this.#read(bytes, start, end + 1) === this.#member;
  }

  /** @returns undefined when it is no JSON text */
  #read(bytes: Uint8Array, start: number, end: number): string | undefined {
    try {
      const text: unknown = JSON.parse(new TextDecoder().decode(bytes.subarray(start, end)));
      return typeof text === 'string' ? text : undefined;
    } catch {
      return undefined;
    }
  }
}
