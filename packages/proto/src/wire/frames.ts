import { varintSize, writeVarint } from '../binary/varint.ts';
import { writeMessage } from '../binary/write-message.ts';
import { encodeErrorMessage } from '../generated/codec.ts';
import type { ErrorMessage } from '../generated/messages.ts';
import type { Init } from '../init.ts';
import { ERROR_TAG, LIST_ELEMENT_TAG, LIST_TAG, RECORD_TAG } from './tags.ts';

/**
 * The bytes that make an encoded record a frame: header followed by record is a `TopicData` with
 * `topic_data_record`.
 *
 * @param recordLength size of the encoded record in bytes
 */
export function recordFrameHeader(recordLength: number): Uint8Array {
  const header = new Uint8Array(1 + varintSize(recordLength));
  header[0] = RECORD_TAG;
  writeVarint(header, 1, recordLength);
  return header;
}

/**
 * A frame with a list of encoded records, in their order: `TopicData` with `topic_data_record_list`.
 * Only for clients that asked for lists. [TD-4]
 */
export function encodeRecordListFrame(records: readonly Uint8Array[]): Uint8Array {
  let listLength = 0;
  for (const record of records) {
    listLength += 1 + varintSize(record.length) + record.length;
  }
  const frame = new Uint8Array(1 + varintSize(listLength) + listLength);
  frame[0] = LIST_TAG;
  let pos = writeVarint(frame, 1, listLength);
  for (const record of records) {
    frame[pos] = LIST_ELEMENT_TAG;
    pos = writeVarint(frame, pos + 1, record.length);
    frame.set(record, pos);
    pos += record.length;
  }
  return frame;
}

/** A frame with an error: `TopicData` with `error`. [TD-17] */
export function encodeErrorFrame(error: Init<ErrorMessage>): Uint8Array {
  return writeMessage((message: Init<ErrorMessage>, writer) => {
    const opened = writer.open(ERROR_TAG);
    encodeErrorMessage(message, writer);
    writer.close(opened);
  }, error);
}
