import { Writer } from './writer.ts';

/**
 * Writers not in use. Memory for a new one costs more than encoding a record, so it is kept; there
 * is more than one only while a message is encoded within the encoding of another.
 */
const idleWriters: Writer[] = [];

/**
 * Encodes with a writer that is lent for the time of the call.
 *
 * @returns what was written, in memory of its own
 */
export function writeMessage<M>(
  encode: (message: M, writer: Writer) => void,
  message: M,
): Uint8Array {
  const writer = idleWriters.pop() ?? new Writer();
  try {
    encode(message, writer);
    return writer.finish();
  } finally {
    writer.clear();
    idleWriters.push(writer);
  }
}
