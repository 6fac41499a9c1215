import { Opcode } from '@mcap/core';
import type { RecordingSource } from '../storage/recording-storage.ts';

/** A record of the data section of a file. */
export interface StoredRecord {
  readonly opcode: number;
  /** Where it begins in the file. */
  readonly offset: bigint;
  /** The whole record, valid until the next one is asked for. */
  readonly bytes: Uint8Array;
  /** What follows opcode and length. */
  readonly content: Uint8Array;
}

const MAGIC_BYTES = 8n;
const HEAD_BYTES = 9;
const WINDOW_BYTES = 4 * 1024 * 1024;

/** Reads the records of a file from its start to the end of the data, or to where the file is cut off. */
export async function* storedRecords(source: RecordingSource): AsyncGenerator<StoredRecord> {
  const size = await source.size();
  let window: Uint8Array = new Uint8Array();
  let windowAt = 0n;
  const take = async (offset: bigint, length: number): Promise<Uint8Array> => {
    const start = Number(offset - windowAt);
    if (start + length <= window.length) return window.subarray(start, start + length);
    const rest = Number(size - offset);
    window = await source.read(offset, BigInt(Math.min(Math.max(length, WINDOW_BYTES), rest)));
    windowAt = offset;
    return window.subarray(0, length);
  };
  for (let offset = MAGIC_BYTES; offset + BigInt(HEAD_BYTES) <= size;) {
    const head = await take(offset, HEAD_BYTES);
    const opcode = head[0]!;
    const length = new DataView(head.buffer, head.byteOffset).getBigUint64(1, true);
    const end = offset + BigInt(HEAD_BYTES) + length;
    if (opcode === 0 || opcode === Number(Opcode.DATA_END) || end > size) return;
    const bytes = await take(offset, HEAD_BYTES + Number(length));
    yield { opcode, offset, bytes, content: bytes.subarray(HEAD_BYTES) };
    offset = end;
  }
}
