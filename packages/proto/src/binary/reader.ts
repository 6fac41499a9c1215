import { MalformedError } from './malformed-error.ts';
import { MAX_NESTED_MESSAGES } from './max-nested-messages.ts';
import { readUtf8 } from './utf8.ts';

/** Numbers are put together here, which is cheaper than a DataView over each message. */
const scratch = new Uint8Array(8);
const scratchView = new DataView(scratch.buffer);

/**
 * Reads the protobuf wire format. Decoding and the structure check share it, so they cannot disagree
 * on what is well-formed. Every method stays before `end`; those named like a type of the schema read
 * one value of it, with an `s` a packed list, appended to the one given.
 *
 * @throws MalformedError from every method, when there is less than it needs or it makes no sense
 */
export class Reader {
  /** Always a plain Uint8Array: views of a Node Buffer would be Buffers again. */
  readonly input: Uint8Array;
  /** Next byte to read. */
  pos = 0;
  /** First byte that does not belong to the message being read. */
  end: number;
  /** Fields whose tag was read. */
  fields = 0;
  /** Reading the tag of one more than so many fails. */
  maxFields = Number.MAX_SAFE_INTEGER;
  #messagesLeft = MAX_NESTED_MESSAGES;

  constructor(input: Uint8Array) {
    this.input =
      input.constructor === Uint8Array
        ? input
        : new Uint8Array(input.buffer, input.byteOffset, input.byteLength);
    this.end = input.byteLength;
  }

  /** Field number and wire type: at most 5 bytes, 32 bits. */
  tag(): number {
    if (++this.fields > this.maxFields) this.#failAtField();
    return this.#uint32(0x0f);
  }

  /** Length of what follows: at most 5 bytes, 31 bits, and no more than there is left. */
  length(): number {
    const length = this.#uint32(0x07);
    if (length > this.end - this.pos) this.#failAtEnd();
    return length;
  }

  /**
   * Enters a length-delimited message: `end` becomes its end.
   *
   * @returns the end of the outer message, to be assigned to `end` when the inner one has been read
   */
  enter(): number {
    if (--this.#messagesLeft < 0) {
      throw new MalformedError(`more than ${MAX_NESTED_MESSAGES} messages within one`);
    }
    const outerEnd = this.end;
    const length = this.length();
    this.end = this.pos + length;
    return outerEnd;
  }

  /** Steps over bytes. */
  skip(length: number): void {
    if (length > this.end - this.pos) this.#failAtEnd();
    this.pos += length;
  }

  /** Steps over a number of variable length: at most 10 bytes. */
  skipVarint(): void {
    const { input, end } = this;
    let pos = this.pos;
    for (let i = 0; i < 10; i++) {
      if (pos >= end) this.#failAtEnd();
      if (input[pos++]! < 0x80) {
        this.pos = pos;
        return;
      }
    }
    this.#failTooLong();
  }

  int32(): number {
    const { input, end } = this;
    let pos = this.pos;
    let value = 0;
    for (let shift = 0; shift < 70; shift += 7) {
      if (pos >= end) this.#failAtEnd();
      const byte = input[pos++]!;
      if (shift < 32) value |= (byte & 0x7f) << shift;
      if (byte < 0x80) {
        this.pos = pos;
        return value;
      }
    }
    return this.#failTooLong();
  }

  /** Exact up to 2^53. */
  int64(): number {
    const { input, end } = this;
    let pos = this.pos;
    let low = 0; // bits 0 to 27
    let middle = 0; // bits 28 to 55
    let high = 0; // bits 56 to 63
    for (let i = 0; i < 10; i++) {
      if (pos >= end) this.#failAtEnd();
      const byte = input[pos++]!;
      if (i < 4) low |= (byte & 0x7f) << (7 * i);
      else if (i < 8) middle |= (byte & 0x7f) << (7 * (i - 4));
      else high |= (byte & 0x7f) << (7 * (i - 8));
      if (byte < 0x80) {
        this.pos = pos;
        high &= 0xff;
        return (high < 0x80 ? high : high - 0x100) * 2 ** 56 + middle * 2 ** 28 + low;
      }
    }
    return this.#failTooLong();
  }

  bool(): boolean {
    const { input, end } = this;
    let pos = this.pos;
    let bits = 0;
    for (let i = 0; i < 10; i++) {
      if (pos >= end) this.#failAtEnd();
      const byte = input[pos++]!;
      bits |= byte & 0x7f;
      if (byte < 0x80) {
        this.pos = pos;
        return bits !== 0;
      }
    }
    return this.#failTooLong();
  }

  float(): number {
    const { input, pos } = this;
    this.skip(4);
    for (let i = 0; i < 4; i++) scratch[i] = input[pos + i]!;
    return scratchView.getFloat32(0, true);
  }

  double(): number {
    const { input, pos } = this;
    this.skip(8);
    for (let i = 0; i < 8; i++) scratch[i] = input[pos + i]!;
    return scratchView.getFloat64(0, true);
  }

  string(): string {
    const length = this.length();
    const start = this.pos;
    this.pos = start + length;
    return readUtf8(this.input, start, this.pos);
  }

  /** A view of the input, not a copy. */
  bytes(): Uint8Array {
    const length = this.length();
    const start = this.pos;
    this.pos = start + length;
    return this.input.subarray(start, this.pos);
  }

  int32s(list: number[]): void {
    const outerEnd = this.enter();
    while (this.pos < this.end) list.push(this.int32());
    this.end = outerEnd;
  }

  bools(list: boolean[]): void {
    const outerEnd = this.enter();
    while (this.pos < this.end) list.push(this.bool());
    this.end = outerEnd;
  }

  floats(list: number[]): void {
    const view = this.#fixedList(4);
    for (let at = 0; at < view.byteLength; at += 4) list.push(view.getFloat32(at, true));
  }

  doubles(list: number[]): void {
    const view = this.#fixedList(8);
    for (let at = 0; at < view.byteLength; at += 8) list.push(view.getFloat64(at, true));
  }

  /** Steps over a packed list of fixed-size numbers; returns its length in bytes. */
  skipFixedList(elementSize: number): number {
    const length = this.length();
    if (length % elementSize !== 0) {
      throw new MalformedError(
        `${length} bytes at ${this.pos} are not a list of numbers of ${elementSize} bytes`,
      );
    }
    this.pos += length;
    return length;
  }

  #fixedList(elementSize: number): DataView {
    const length = this.skipFixedList(elementSize);
    const { buffer, byteOffset } = this.input;
    return new DataView(buffer, byteOffset + this.pos - length, length);
  }

  #uint32(lastByteLimit: number): number {
    const { input, end } = this;
    let pos = this.pos;
    if (pos >= end) this.#failAtEnd();
    let byte = input[pos++]!;
    let value = byte & 0x7f;
    for (let shift = 7; byte >= 0x80; shift += 7) {
      if (pos >= end) this.#failAtEnd();
      byte = input[pos++]!;
      if (shift === 28 && byte > lastByteLimit) this.#failTooLong();
      value |= (byte & 0x7f) << shift;
    }
    this.pos = pos;
    return value >>> 0;
  }

  #failAtEnd(): never {
    throw new MalformedError(
      `what starts at byte ${this.pos} does not end before byte ${this.end}`,
    );
  }

  #failAtField(): never {
    throw new MalformedError(`too many fields before byte ${this.pos}`);
  }

  #failTooLong(): never {
    throw new MalformedError(`the number at byte ${this.pos} is too long`);
  }
}
