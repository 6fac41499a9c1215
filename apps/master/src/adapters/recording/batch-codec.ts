import type { RecordSource, RecordToKeep } from '../../core/ports/index.ts';

/** A batch as it goes to the thread: one piece of memory, which is handed over. */
export interface EncodedBatch {
  /** Four numbers (double) for each record: number of its source, targets, bytes, time; then the bytes of all. */
  readonly buffer: ArrayBuffer;
  readonly count: number;
}

const NUMBERS = 4;
const NUMBER_BYTES = 8;

/** @param numberOf the number that the thread knows a source by */
export function encodeBatch(
  records: readonly RecordToKeep[],
  numberOf: (source: RecordSource) => number,
): EncodedBatch {
  const headBytes = records.length * NUMBERS * NUMBER_BYTES;
  let bytes = headBytes;
  for (const { record } of records) bytes += record.byteLength;
  const buffer = new ArrayBuffer(bytes);
  const head = new Float64Array(buffer, 0, records.length * NUMBERS);
  const body = new Uint8Array(buffer);
  let offset = headBytes;
  let at = 0;
  for (const { source, record, timeMs, targets } of records) {
    // One by one: an array of the four costs more than the copy of a small record.
    head[at++] = numberOf(source);
    head[at++] = targets;
    head[at++] = record.byteLength;
    head[at++] = timeMs;
    body.set(record, offset);
    offset += record.byteLength;
  }
  return { buffer, count: records.length };
}

/** The records of a batch; their bytes are views of it. */
export function decodeBatch(
  { buffer, count }: EncodedBatch,
  sources: readonly RecordSource[],
): RecordToKeep[] {
  const head = new Float64Array(buffer, 0, count * NUMBERS);
  let offset = head.byteLength;
  return Array.from({ length: count }, (_, index) => {
    const at = index * NUMBERS;
    const byteLength = head[at + 2]!;
    const record = new Uint8Array(buffer, offset, byteLength);
    offset += byteLength;
    return { source: sources[head[at]!]!, record, timeMs: head[at + 3]!, targets: head[at + 1]! };
  });
}
