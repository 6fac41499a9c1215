import { MAX_GROUP_DEPTH } from '../protobuf.ts';
import { MalformedError } from './malformed-error.ts';

/**
 * Moves over encoded bytes without making anything. Every method checks that it stays before `end`
 * and throws a MalformedError that says where it could not.
 */
export class Cursor {
  readonly bytes: Uint8Array;
  /** Next byte to read. */
  pos: number;
  /** First byte that does not belong to the message being read. */
  end: number;

  constructor(bytes: Uint8Array, start: number, end: number) {
    this.bytes = bytes;
    this.pos = start;
    this.end = end;
  }

  /** Field number and wire type: at most 5 bytes, 32 bits. */
  readTag(): number {
    return this.#readUint32(0x0f, 'tag');
  }

  /** Length of what follows: at most 5 bytes, 31 bits, and no more than there is left. */
  readLength(): number {
    const length = this.#readUint32(0x07, 'length');
    if (length > this.end - this.pos) {
      throw new MalformedError(`${length} bytes at ${this.pos} end after byte ${this.end}`);
    }
    return length;
  }

  #readUint32(lastByteLimit: number, what: string): number {
    const { bytes, end } = this;
    let pos = this.pos;
    if (pos >= end) throw new MalformedError(`a ${what} at ${pos} ends after byte ${end}`);
    let byte = bytes[pos++]!;
    let value = byte & 0x7f;
    for (let shift = 7; byte >= 0x80; shift += 7) {
      if (pos >= end) throw new MalformedError(`a ${what} at ${this.pos} ends after byte ${end}`);
      byte = bytes[pos++]!;
      if (shift === 28 && byte > lastByteLimit) {
        throw new MalformedError(`a ${what} at ${this.pos} is too large`);
      }
      value |= (byte & 0x7f) << shift;
    }
    this.pos = pos;
    return value >>> 0;
  }

  /** Steps over a number of variable length: at most 10 bytes. */
  skipVarint(): void {
    const { bytes, end, pos: start } = this;
    const limit = Math.min(start + 10, end);
    let pos = start;
    while (pos < limit) {
      if (bytes[pos++]! < 0x80) {
        this.pos = pos;
        return;
      }
    }
    throw new MalformedError(
      pos - start === 10
        ? `a number at ${start} is longer than 10 bytes`
        : `a number at ${start} ends after byte ${end}`,
    );
  }

  skipBytes(length: number): void {
    if (length > this.end - this.pos) {
      throw new MalformedError(`${length} bytes at ${this.pos} end after byte ${this.end}`);
    }
    this.pos += length;
  }

  /** Steps over a field that the schema does not have, or not with this wire type. */
  skipField(tag: number, depth = 0): void {
    if (tag >>> 3 === 0) throw new MalformedError(`field number 0 before ${this.pos}`);
    switch (tag & 7) {
      case 0:
        return this.skipVarint();
      case 1:
        return this.skipBytes(8);
      case 2:
        return this.skipBytes(this.readLength());
      case 3:
        return this.#skipGroup(tag, depth + 1);
      case 5:
        return this.skipBytes(4);
      default:
        throw new MalformedError(`wire type ${tag & 7} of field ${tag >>> 3} before ${this.pos}`);
    }
  }

  #skipGroup(startTag: number, depth: number): void {
    if (depth > MAX_GROUP_DEPTH)
      throw new MalformedError(`groups nest deeper than ${MAX_GROUP_DEPTH}`);
    for (;;) {
      const tag = this.readTag();
      if ((tag & 7) === 4) {
        if (tag >>> 3 === startTag >>> 3) return;
        throw new MalformedError(`group ${startTag >>> 3} ends as group ${tag >>> 3}`);
      }
      this.skipField(tag, depth);
    }
  }
}
