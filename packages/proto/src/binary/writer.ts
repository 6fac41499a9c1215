import { isBytes } from './is-bytes.ts';
import { varintSize, writeVarint } from './varint.ts';

/** Size a writer starts with, bytes: enough for most records. */
const START_SIZE = 1024;
/** A writer that has grown beyond this, bytes, does not keep its memory. */
const KEEP_SIZE = 1024 * 1024;

/** Up to this length, characters, a call into the platform's encoder costs more than it saves. */
const SHORT_TEXT = 24;

const textEncoder = new TextEncoder();

/** Numbers are taken apart here, which is cheaper than a DataView over the output. */
const scratch = new Uint8Array(8);
const scratchView = new DataView(scratch.buffer);

/**
 * Writes the protobuf wire format. Methods named like a type of the schema write a field of it, tag
 * included; with an `s`, a packed list.
 */
export class Writer {
  #output = new Uint8Array(START_SIZE);
  #pos = 0;

  /**
   * A copy of what was written, in memory of its own; the writer is empty afterwards.
   */
  finish(): Uint8Array {
    const bytes = this.#output.slice(0, this.#pos);
    this.clear();
    return bytes;
  }

  /** Forgets what was written. */
  clear(): void {
    this.#pos = 0;
    if (this.#output.length > KEEP_SIZE) this.#output = new Uint8Array(START_SIZE);
  }

  /**
   * Begins a nested message.
   *
   * @returns what `close` needs to end it
   */
  open(tag: number): number {
    this.#reserve(6);
    this.#varint(tag);
    return this.#pos++;
  }

  /** Ends a nested message: writes its length before it, moving it when that takes several bytes. */
  close(opened: number): void {
    const start = opened + 1;
    const length = this.#pos - start;
    if (length < 0x80) {
      this.#output[opened] = length;
      return;
    }
    const extra = varintSize(length) - 1;
    this.#reserve(extra);
    this.#output.copyWithin(start + extra, start, this.#pos);
    this.#pos = opened;
    this.#varint(length);
    this.#pos += length;
  }

  int32(tag: number, value: number): void {
    this.#reserve(15);
    this.#varint(tag);
    this.#int32(value);
  }

  /** Exact up to 2^53; a fraction is dropped. */
  int64(tag: number, value: number): void {
    this.#reserve(15);
    this.#varint(tag);
    this.#int64(value);
  }

  bool(tag: number, value: boolean): void {
    this.#reserve(6);
    this.#varint(tag);
    this.#output[this.#pos++] = value ? 1 : 0;
  }

  float(tag: number, value: number): void {
    this.#reserve(9);
    this.#varint(tag);
    this.#float(value);
  }

  double(tag: number, value: number): void {
    this.#reserve(13);
    this.#varint(tag);
    this.#double(value);
  }

  /**
   * Half a surrogate pair, which UTF-8 cannot express, becomes U+FFFD.
   *
   * @throws TypeError when the value is not text
   */
  string(tag: number, value: string): void {
    if (typeof value !== 'string') throw new TypeError(`expected text, got ${typeof value}`);
    const { length } = value;
    // No character takes more than 3 bytes of UTF-8 for each of its UTF-16 units.
    this.#reserve(6 + 3 * length);
    this.#varint(tag);
    const opened = this.#pos++;
    if (length <= SHORT_TEXT && this.#ascii(value)) {
      this.#output[opened] = length;
      return;
    }
    this.#pos = opened + 1;
    this.#pos += textEncoder.encodeInto(value, this.#output.subarray(this.#pos)).written;
    this.close(opened);
  }

  /** @throws TypeError when the value is not an array of bytes */
  bytes(tag: number, value: Uint8Array | Uint8ClampedArray): void {
    if (!isBytes(value)) throw new TypeError(`expected a Uint8Array, got ${typeof value}`);
    this.#reserve(10 + value.length);
    this.#varint(tag);
    this.#varint(value.length);
    this.#output.set(value, this.#pos);
    this.#pos += value.length;
  }

  int32s(tag: number, list: ArrayLike<number>): void {
    const opened = this.open(tag);
    this.#reserve(10 * list.length);
    for (let i = 0; i < list.length; i++) this.#int32(list[i]!);
    this.close(opened);
  }

  bools(tag: number, list: ArrayLike<boolean>): void {
    this.#reserve(10 + list.length);
    this.#varint(tag);
    this.#varint(list.length);
    for (let i = 0; i < list.length; i++) this.#output[this.#pos++] = list[i]! ? 1 : 0;
  }

  floats(tag: number, list: ArrayLike<number>): void {
    this.#reserve(10 + 4 * list.length);
    this.#varint(tag);
    this.#varint(4 * list.length);
    for (let i = 0; i < list.length; i++) this.#float(list[i]!);
  }

  doubles(tag: number, list: ArrayLike<number>): void {
    this.#reserve(10 + 8 * list.length);
    this.#varint(tag);
    this.#varint(8 * list.length);
    for (let i = 0; i < list.length; i++) this.#double(list[i]!);
  }

  /** The methods below write without a tag, into memory that was reserved. */
  #ascii(text: string): boolean {
    const output = this.#output;
    let pos = this.#pos;
    for (let i = 0; i < text.length; i++) {
      const code = text.charCodeAt(i);
      if (code >= 0x80) return false;
      output[pos++] = code;
    }
    this.#pos = pos;
    return true;
  }

  #varint(value: number): void {
    this.#pos = writeVarint(this.#output, this.#pos, value);
  }

  /** Negative numbers take 10 bytes, as those of 64 bits do. */
  #int32(value: number): void {
    const integer = value | 0;
    if (integer < 0) this.#int64(integer);
    else this.#varint(integer);
  }

  #int64(value: number): void {
    const integer = Math.trunc(value);
    let high = Math.floor(integer / 2 ** 32) >>> 0;
    let low = integer >>> 0;
    const output = this.#output;
    let pos = this.#pos;
    while (high > 0 || low >= 0x80) {
      output[pos++] = (low & 0x7f) | 0x80;
      low = ((low >>> 7) | (high << 25)) >>> 0;
      high >>>= 7;
    }
    output[pos++] = low;
    this.#pos = pos;
  }

  #float(value: number): void {
    scratchView.setFloat32(0, value, true);
    for (let i = 0; i < 4; i++) this.#output[this.#pos++] = scratch[i]!;
  }

  #double(value: number): void {
    scratchView.setFloat64(0, value, true);
    for (let i = 0; i < 8; i++) this.#output[this.#pos++] = scratch[i]!;
  }

  #reserve(length: number): void {
    const needed = this.#pos + length;
    if (needed <= this.#output.length) return;
    const larger = new Uint8Array(Math.max(needed, 2 * this.#output.length));
    larger.set(this.#output.subarray(0, this.#pos));
    this.#output = larger;
  }
}
